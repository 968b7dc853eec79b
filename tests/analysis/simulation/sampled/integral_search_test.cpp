// Larger disturbances of loops that integrate: their slowest mode is the integral's, and no measure of a pull.
#include <catch2/catch.hpp>

#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("stable loops that integrate are followed from large disturbances to their end", "[sampled][integral][slow]")
{
    struct Loop {
        double k_i, k_p;
    };
    // critical gains by the quadratic of the linear theory: 56 087 and 119 363 N/m
    for (const Loop asked : {Loop{1e5, 6e4}, Loop{1e5, 7e4}, Loop{1e7, 1.3e5}, Loop{1e4, 9e4}, Loop{1e3, 9e4}}) {
        Joint joint = example_joint(asked.k_p, 10, 1e-3);
        joint.control.k_i = asked.k_i;
        const auto verdict = loop_verdict(joint, {});
        CHECK(verdict.region == NonlinearRegion::stable);
        CHECK(verdict.reason == Reason::none);
    }
}

TEST_CASE("the slow mode of an integral is found beside what steady sliding holds", "[sampled][integral][slow]")
{
    // −k_i/k_p to first order: a thousandth of a tick's digits, which drowned in an integral of 60 N/k_i
    for (const double k_i : {1e3, 1e4, -1e3, -1e4}) {
        Joint joint = example_joint(9e4, 10, 1e-3);
        joint.control.k_i = k_i;
        CHECK(loop_verdict(joint, {}).growth_rate == Approx(growth_rate(joint)).epsilon(1e-2));
    }
}

TEST_CASE("a cycle beside a slow integral is waited for", "[sampled][integral][slow]")
{
    // below its critical gain; what the integral adds to the cycle is of first order in k_i
    Joint joint = example_joint(5e4, 10, 1e-3);
    joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    const auto amplitude = [&](double k_i) {
        joint.control.k_i = k_i;
        const auto verdict = loop_verdict(joint, {});
        REQUIRE(verdict.cycle.kind == LoopEnd::Kind::cycle);
        return verdict.cycle.amplitude;
    };
    const double none = amplitude(0), half = amplitude(5e3), whole = amplitude(1e4);
    CHECK(none == Approx(22.1829e-6).epsilon(1e-5));
    CHECK((whole - none) / (half - none) == Approx(2).epsilon(0.02));
    CHECK(whole == Approx(none).epsilon(0.03));
}
