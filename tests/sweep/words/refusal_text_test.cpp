#include "sweep/words/refusal_text.h"

#include "analysis/results/not_fitted.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Why = CannotAnswer::Why;

TEST_CASE("every refusal has its own words, after what it is about", "[text]")
{
    std::vector<std::string> said;
    for (int i = 0; i <= static_cast<int>(Why::short_motion); ++i) {
        const CannotAnswer refused(static_cast<Why>(i), "run.csv", "control.k_x", {7, 0.25});
        CAPTURE(CannotAnswer::name_of(refused.why));
        const auto text = cannot_answer_text(refused);
        CHECK_THAT(text, Catch::StartsWith("run.csv: "));
        CHECK(text.size() > std::string("run.csv: ").size());
        CHECK(std::find(said.begin(), said.end(), text) == said.end());
        said.push_back(text);
    }
}

TEST_CASE("a refusal with numbers says them, one without a code its own words", "[text]")
{
    CHECK(refusal_text(CannotAnswer(Why::time_runs_back, "run.csv", "", {3, 0.002})) ==
          "run.csv: time runs backwards in row 3 (0.002000 s)");
    CHECK(refusal_text(CannotAnswer(Why::column_length, "run.csv", "velocity", {5, 100})) ==
          "run.csv: column velocity has 5 values, time has 100");
    CHECK(refusal_text(CannotAnswer(Why::no_period, "")) == "control.period is missing: a plan needs a sampled loop");
    CHECK(refusal_text(std::invalid_argument("is not a number")) == "is not a number");
    CHECK_THAT(refusal_text(NotFitted(NotFitted::Why::other_law, "kernel")), Catch::Contains("kernel"));
    // a program reads the code
    CHECK(CannotAnswer(Why::no_parameter, "run.csv", "control.k_x").what() ==
          std::string("run.csv: no-parameter control.k_x"));
}
