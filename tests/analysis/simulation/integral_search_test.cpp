// Larger disturbances of loops that integrate: their slowest mode is the integral's, and no measure of a pull.
#include <catch2/catch.hpp>

#include "analysis/simulation/sampled/loop_verdict.h"

using namespace stickslip;

TEST_CASE("stable loops that integrate are followed from large disturbances to their end", "[sampled][integral]")
{
    struct Loop {
        double k_i, k_p;
    };
    // critical gains by the quadratic of the linear theory: 56 087 and 119 363 N/m
    for (const Loop asked : {Loop{1e5, 6e4}, Loop{1e5, 7e4}, Loop{1e7, 1.3e5}}) {
        Joint joint;
        joint.mechanism.inertia = 1;
        joint.control.k_p = asked.k_p;
        joint.control.k_i = asked.k_i;
        joint.control.k_v = 10;
        joint.control.V0 = 1e-3;
        RateAndState law;
        law.f0 = 60, law.A = 1, law.V_star = 1e-3;
        law.B.push_back(1.5), law.L.push_back(1e-5);
        joint.friction.law = law;
        const auto verdict = loop_verdict(joint, {});
        CHECK(verdict.region == LoopRegion::stable);
        CHECK(verdict.reason == Reason::none);
    }
}
