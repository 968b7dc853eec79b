// Numbers of the linear study that do not exist, and the words in their place.
#include "sweep/files/json/study_json.h"

#include "sweep/report/pages/figures_report.h"

#include <catch2/catch.hpp>

using namespace stickslip;
using Catch::Matchers::Contains;

namespace {

nlohmann::ordered_json study_at(double k_p, double k_v)
{
    Joint joint = paper_joint();
    joint.control.k_p = k_p;
    joint.control.k_v = k_v;
    return study_json(linear_study(joint), coarse_root_locus(joint));
}

std::string reason(const nlohmann::ordered_json& part)
{
    return part["reason"].is_null() ? "" : part["reason"].get<std::string>();
}

}  // namespace

TEST_CASE("what a linear study leaves out has its reason beside it", "[files]")
{
    // k_cr = 55 kN/m: above it no gain is too high
    const auto stable = study_at(6e4, 0);
    CHECK(stable["margins"]["gain_below"].get<double>() == Approx(55.0 / 60));
    CHECK(stable["margins"]["gain_above"].is_null());
    CHECK_THAT(reason(stable["margins"]), Contains("gain_above: no boundary lies above this k_p"));
    CHECK(reason(stable["response"]).empty());
    // stable up to 1.4 mm/s, unstable beyond
    const auto& slow = stable["velocities"]["state_variable"];
    CHECK(slow["all_above"].is_null());
    CHECK_THAT(reason(slow),
               Contains("the least lies below it") && Contains("highest velocity searched is not stable"));

    const auto unstable = study_at(2e4, 0);
    CHECK(unstable["margins"]["gain_below"].is_null());
    CHECK_THAT(reason(unstable["margins"]), Contains("not stable"));
    CHECK(unstable["response"]["peak"].is_null());
    CHECK_THAT(reason(unstable["response"]), Contains("there is no steady response to a sine"));
    CHECK_THAT(reason(unstable["velocities"]["state_variable"]), Contains("no velocity of the searched range"));
}
