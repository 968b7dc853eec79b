// Loops so overdamped that what disturbs them dies away without a turn.
#include <catch2/catch.hpp>

#include "analysis/simulation/sampled/loop_verdict.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("an overdamped joint comes back from larger disturbances without a turn", "[sampled][overdamped]")
{
    // friction that rises with speed from one level, at rest and sliding, holds nothing back and feeds no oscillation
    for (const bool sampled : {true, false}) {
        Joint joint;
        joint.mechanism.inertia = 1;
        joint.control.k_p = 80, joint.control.V0 = 3e-3;
        if (sampled) joint.control.period = 1e-3, joint.control.velocity_estimate.form = EstimateForm::exact;
        joint.actuator.lag = 4e-3;
        joint.friction.law = CoulombViscous{8, 240};
        CAPTURE(sampled);
        const auto verdict = loop_verdict(joint, {});
        CHECK(verdict.region == NonlinearRegion::stable);
        CHECK(verdict.reason == Reason::none);
        // the slow root of (λ² + 240 λ)(1 + lag λ) + 80 by Newton's method; half a tick of hold adds 2e-4 to it
        double root = -80.0 / 240;
        for (int i = 0; i < 20; ++i) {
            const double lagged = 1 + 4e-3 * root, free = root * (root + 240);
            root -= (free * lagged + 80) / ((2 * root + 240) * lagged + free * 4e-3);
        }
        CHECK(verdict.growth_rate == Approx(root).epsilon(4e-4));
    }
}
