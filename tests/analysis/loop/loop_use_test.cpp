// What a verdict says that it leaves out, of joints with several bodies.
#include "analysis/loop/loop_use.h"
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
