// A record of a loop that leaves its reference says that the loop is unstable.
#include "sweep/study/loop_growth.h"
#include "analysis/joint/loop_side.h"
#include "analysis/stability/verdict.h"
#include "sweep/words/loop_text.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace stickslip;
using Catch::Contains;

namespace {

/// Behind a gear of 10:1, with a gain of the motor that is a hundred times as large at the joint, and stable at 0.6.
Joint geared(double k_p)
{
    Joint joint;
    auto& m = joint.mechanism;
    m.motion = Motion::revolute, m.model = Model::two_mass;
    m.motor_inertia = 3e-4, m.link_inertia = 0.03;
    m.transmission.stiffness = 100, m.transmission.damping = 0.02, m.transmission.ratio = 10;
    joint.control.k_p = k_p, joint.control.k_v = k_p / 60, joint.control.V0 = 0.05;
    joint.control.period = 1e-3;
    joint.control.velocity_estimate = {EstimateForm::backward_difference, 3e-3};
    joint.frictions.motor.law = Stribeck{0.02, 2e-4, 0.02, 0.5, 2};
    joint.frictions.link.law = CoulombViscous{0.1, 0};
    return joint;
}

LoopRecord along_a_sine(const Joint& joint)
{
    ReferenceMotion reference;
    for (int i = 0; i <= 10000; ++i) {
        reference.time.push_back(1e-3 * i);
        reference.position.push_back(0.3 * std::sin(2 * reference.time.back()));
    }
    return record_along(joint, reference, 0);
}

}  // namespace

TEST_CASE("A loop that diverges along its reference is said to be unstable, by the growth of its verdict", "[loop]")
{
    const Joint joint = geared(60);
    const auto record = along_a_sine(joint);
    REQUIRE(record.reason != Reason::none);
    const auto loop = unstable_loop(joint, record);
    REQUIRE(loop);
    CHECK(loop->diverges);
    CHECK(loop->farthest > 1e100);
    CHECK(loop->velocity == Approx(0.06).epsilon(1e-3));
    Joint there = with_loop_at_joint(joint);
    there.control.V0 = loop->velocity;
    CHECK(loop->growth == growth_rate(there));
    CHECK(loop->growth > 0);
    CHECK_THAT(unstable_loop_text(*loop, units_of(joint)),
               Contains("The loop diverges: its position runs ") &&
                   Contains(" off the reference. It is unstable: small "
                            "disturbances of sliding at 0.06 rad/s grow at "));
}

TEST_CASE("A record to its end, and one that ends early for another reason, accuse no loop", "[loop]")
{
    const Joint joint = geared(0.6);
    auto record = along_a_sine(joint);
    REQUIRE(record.reason == Reason::none);
    CHECK_FALSE(unstable_loop(joint, record));
    Joint there = with_loop_at_joint(joint);
    there.control.V0 = 0.06;
    REQUIRE(growth_rate(there) > 0);  // it sticks and slips, within its bounds
    record.reason = Reason::law_needs_motion;
    const auto unstable = unstable_loop(joint, record);
    REQUIRE(unstable);
    CHECK_FALSE(unstable->diverges);
    CHECK_THAT(unstable_loop_text(*unstable, units_of(joint)), Contains("The loop is unstable: small disturbances"));
    Joint rough = joint;
    rough.frictions.motor.law = CoulombViscous{0.02, 0.002};
    CHECK_FALSE(unstable_loop(rough, record));
}
