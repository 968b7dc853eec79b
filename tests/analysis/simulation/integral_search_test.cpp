// Larger disturbances of loops that integrate: their slowest mode is the integral's, and no measure of a pull.
#include <catch2/catch.hpp>

#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("stable loops that integrate are followed from large disturbances to their end", "[sampled][integral]")
{
    struct Loop {
        double k_i, k_p;
    };
    // critical gains by the quadratic of the linear theory: 56 087 and 119 363 N/m
    for (const Loop asked : {Loop{1e5, 6e4}, Loop{1e5, 7e4}, Loop{1e7, 1.3e5}, Loop{1e4, 9e4}, Loop{1e3, 9e4}}) {
        Joint joint = example_joint(asked.k_p, 10, 1e-3);
        joint.control.k_i = asked.k_i;
        const auto verdict = loop_verdict(joint, {});
        CHECK(verdict.region == LoopRegion::stable);
        CHECK(verdict.reason == Reason::none);
    }
}

TEST_CASE("the slow mode of an integral is found beside what steady sliding holds", "[sampled][integral]")
{
    // −k_i/k_p to first order: a thousandth of a tick's digits, which drowned in an integral of 60 N/k_i
    for (const double k_i : {1e3, 1e4, -1e3, -1e4}) {
        Joint joint = example_joint(9e4, 10, 1e-3);
        joint.control.k_i = k_i;
        CHECK(loop_verdict(joint, {}).growth_rate == Approx(growth_rate(joint)).epsilon(1e-2));
    }
}
