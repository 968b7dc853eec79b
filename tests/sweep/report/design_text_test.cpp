// A design in words: an optimum at the end of the search is said to be one.
#include "sweep/report/pages/design_report.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("the answer of a design says that its optimum sits on the limit of the search", "[report]")
{
    DesignAnswer answer;
    answer.joint.control.k_p = 1e4;
    answer.range = {{1e3, 2e5}, {0, 100}};
    auto& d = answer.design;
    d.decided = d.feasible = true;
    d.best.k_p = 2e5, d.best.k_v = 40;
    d.best.margin = 0.2;
    const auto on = design_text(answer);
    CHECK(on.find("The best k_{p} lies at the upper limit of the search") != std::string::npos);
    d.best.k_p = 1e5;
    CHECK(design_text(answer).find("search limit") == std::string::npos);
}

TEST_CASE("a design says how far behind its reference the link slides with the gains that it chooses", "[report]")
{
    DesignAnswer answer;
    answer.joint.control.k_p = 1e4;
    answer.design.decided = answer.design.feasible = true;
    auto& best = answer.design.best;
    best.k_p = 60, best.k_v = 10, best.margin = 0.2, best.steady_deflection = -1;
    CHECK(design_text(answer).find("Steady sliding stays 1 m behind the reference") != std::string::npos);
    CHECK(design_tables(answer)[0].rows[0][6] == "−1 m");
    const auto page = design_report(answer);
    CHECK(std::any_of(page.headlines.begin(), page.headlines.end(), [](const Headline& h) {
        return h.value == "1 m" && h.meaning == "steady deflection behind the reference";
    }));
}

TEST_CASE("a design without a velocity says that it has none, and blames no limit", "[report]")
{
    DesignAnswer answer;
    answer.joint.mechanism.inertia = 1, answer.joint.control.k_p = 1e4;
    answer.joint.friction.law = Stribeck{10, 5, 3, 0.01, 2};
    const auto text = design_text(answer);
    CHECK(text.find("control.V0") != std::string::npos);
    CHECK(text.find("sag_effort") == std::string::npos);
}
