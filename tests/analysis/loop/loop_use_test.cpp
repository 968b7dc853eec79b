// What a verdict says that it leaves out, of joints with several bodies.
#include "analysis/loop/loop_use.h"
#include <cmath>
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace stickslip;

namespace {

const UnusedTerm* told(const LoopUse& use, const std::string& key)
{
    const auto found =
        std::find_if(use.not_used.begin(), use.not_used.end(), [&](const UnusedTerm& t) { return t.key == key; });
    return found == use.not_used.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("Ripple and drift of each body are told where the linear theory leaves them out", "[loop]")
{
    Joint joint = example_joint(60e3, 10, 1e-3);
    joint.mechanism.model = Model::two_mass;
    joint.mechanism.motor_inertia = joint.mechanism.link_inertia = 1;
    joint.mechanism.transmission.stiffness = 1e6;
    joint.frictions.motor.law = joint.frictions.link.law = CoulombViscous{3, 0};
    CHECK(loop_use(joint).not_used.empty());
    joint.frictions.link.ripple.amplitude = 0.1;
    joint.frictions.link.ripple.periods = 1e4;  // 1 N/mm beside 60
    joint.frictions.motor.ripple.amplitude = 1e-3;
    joint.frictions.motor.drift.change = 2;
    const auto use = loop_use(joint);
    REQUIRE(told(use, "friction.link.ripple"));
    CHECK(told(use, "friction.link.ripple")->matters);
    REQUIRE(told(use, "friction.motor.ripple"));
    CHECK_FALSE(told(use, "friction.motor.ripple")->matters);
    REQUIRE(told(use, "friction.motor.drift"));
    // behind a gear the same ripple is steeper by the square of its ratio, counted at the joint
    joint.mechanism.transmission.ratio = 3000;
    CHECK(told(loop_use(joint), "friction.motor.ripple")->matters);
    joint.mechanism.model = Model::three_mass;
    joint.frictions.transmission.ripple.second_amplitude = 1;
    CHECK(told(loop_use(joint), "friction.transmission.ripple"));
}

TEST_CASE("A force in time matters where the motion that it forces is felt beside V_0", "[loop]")
{
    // 60 kN/m, 1 kg, 10 N·s/m at 1 mm/s: of 20 N at 70 rad/s the impedance |60000/70 − 70 + 10i| = 787 N·s/m leaves
    // 25 mm/s; of 1 N at 0.1 rad/s the spring alone, 0.1/60000 = 1.7 µm/s, less than a hundredth
    Joint joint = example_joint(60e3, 10, 1e-3);
    auto& d = joint.load.disturbance;
    d.amplitude = 20, d.frequency = 70;
    REQUIRE(told(loop_use(joint), "load.disturbance"));
    CHECK(told(loop_use(joint), "load.disturbance")->matters);
    d.amplitude = 1, d.frequency = 0.1;
    CHECK_FALSE(told(loop_use(joint), "load.disturbance")->matters);
    d.amplitude = 7;  // 12 µm/s
    CHECK(told(loop_use(joint), "load.disturbance")->matters);
    // 1 mN is felt at the resonance of 245 rad/s only, which k_v alone damps: 0.1 mm/s
    d.amplitude = 1e-3, d.frequency = std::sqrt(60e3);
    CHECK(told(loop_use(joint), "load.disturbance")->matters);
    d.frequency = 100;
    CHECK_FALSE(told(loop_use(joint), "load.disturbance")->matters);
}

TEST_CASE("Keys of another kind of control, or overruled by one, are told", "[loop]")
{
    Joint joint = example_joint(60e3, 10, 1e-3);
    CHECK(loop_use(joint).not_used.empty());
    joint.control.force_rate = 1, joint.control.force_gain = 0.5;
    REQUIRE(told(loop_use(joint), "control.force_rate"));
    CHECK(told(loop_use(joint), "control.force_rate")->why == WhyNot::other_kind);
    REQUIRE(told(loop_use(joint), "control.force_gain"));
    CHECK_FALSE(told(loop_use(joint), "control.V0"));
    joint.control.kind = ControlKind::force;
    CHECK_FALSE(told(loop_use(joint), "control.force_rate"));
    CHECK_FALSE(told(loop_use(joint), "control.force_gain"));
    REQUIRE(told(loop_use(joint), "control.V0"));
    CHECK(told(loop_use(joint), "control.V0")->why == WhyNot::overruled);
    joint.control.force_rate = not_set;
    CHECK_FALSE(told(loop_use(joint), "control.V0"));
}

TEST_CASE("A sampled loop that is told its velocity says that it filters none", "[loop]")
{
    Joint joint = ticked_joint(60e3);
    joint.control.velocity_estimate = {EstimateForm::exact, 0.05, 4};
    for (const char* key : {"control.velocity_estimate.tau", "control.velocity_estimate.average"}) {
        const LoopUse use = loop_use(joint);
        const auto* term = told(use, key);
        REQUIRE(term);
        CHECK(term->why == WhyNot::told_velocity);
        CHECK(term->matters);
    }
    joint.control.period = not_set;
    CHECK_FALSE(told(loop_use(joint), "control.velocity_estimate.tau"));
}
