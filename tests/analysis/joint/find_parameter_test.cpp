// A number is found by its path: the same one that the list of all numbers has there.
#include "analysis/joint/parameters.h"
#include "tests/analysis/joint/sample_joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

TEST_CASE("every number of a joint is found by its path", "[joint]")
{
    Joint lagging = samples::single_mass(1);
    lagging.friction.law = samples::time_lag(Stribeck{40, 120, 25, 0.015, 1});
    for (Joint joint :
         {samples::single_mass(1), samples::two_mass(), samples::three_mass(), samples::nine_states(), lagging}) {
        for (const auto& p : parameters(joint)) {
            CAPTURE(p.path);
            CHECK(find_parameter(joint, p.path) == p.value);
            CHECK(find_parameter(joint, p.path + "x") == nullptr);
        }
    }
    Joint one = samples::single_mass(1);
    CHECK(find_parameter(one, "friction.L.0") == find_parameter(one, "friction.L"));
    CHECK(find_parameter(one, "friction.L") != nullptr);
    CHECK(find_parameter(one, "friction.L.1") == nullptr);
    CHECK(find_parameter(one, "friction") == nullptr);
}
