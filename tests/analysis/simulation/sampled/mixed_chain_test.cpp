// Chains in which one body can rest and another, whose friction needs motion, only creeps.
#include <catch2/catch.hpp>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/sampled/loop_verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("sampled loop: larger disturbances are followed where one body can rest and another only creeps", "[sampled]")
{
    // against the continuous chain, which the loop becomes as its ticks grow short
    for (const double k_p : {5e4, 2e5}) {
        Joint joint = ticked_joint(k_p);
        auto& m = joint.mechanism;
        m.model = Model::two_mass, m.motor_inertia = 0.5, m.link_inertia = 0.5;
        m.transmission.stiffness = 3e6, m.transmission.damping = 400;
        joint.frictions.motor.law = CoulombViscous{.coulomb = 5, .viscous = 20};
        joint.frictions.link = joint.friction;
        joint.control.period = 1e-4;
        const auto sampled = loop_verdict(joint, {});
        joint.control.period = not_set, joint.control.velocity_estimate = {};
        const auto continuous = nonlinear_verdict(joint, {});
        INFO("k_p " << k_p);
        CHECK(continuous.region != NonlinearRegion::undecided);
        CHECK(sampled.region == continuous.region);
        CHECK(sampled.reason == Reason::none);
    }
}
