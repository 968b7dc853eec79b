// What the controller has to ask for in steady sliding, and how far the joint is behind for it.
#include "analysis/joint/drive.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>
#include <random>

using namespace stickslip;

TEST_CASE("the command for an effort makes this effort", "[stability][steady]")
{
    std::mt19937_64 random(20261125);
    std::uniform_real_distribution<double> part(0.1, 1);
    for (int i = 0; i < 300; ++i) {
        Actuator a;
        a.effort_gain = 2 * part(random);
        const double velocity = i % 2 ? part(random) : -part(random);
        double effort = velocity > 0 ? part(random) : -part(random);
        if (i % 3 == 0) {
            if (i % 5 == 0) a.sag_effort = 5 * part(random) + 1;
        } else {
            a.kind = ActuatorKind::dc_motor;
            a.k_t = 0.3 * part(random), a.k_e = 0.3 * part(random), a.resistance = 3 * part(random);
            a.signal = i % 3 == 1 ? DriveSignal::duty : DriveSignal::voltage;
            if (a.signal == DriveSignal::duty || i % 5 == 0) {
                a.supply_voltage = 200;
                if (i % 7 < 4) a.supply_resistance = a.resistance * part(random);
            }
        }
        CAPTURE(i, effort, velocity);
        CHECK(push_of(a, command_for(a, effort, velocity), a.supply_voltage, velocity).at(velocity) ==
              Approx(effort).epsilon(1e-12));
    }
}

TEST_CASE("a motor behind its winding is as far behind as its voltage asks for", "[stability][steady]")
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute, joint.mechanism.inertia = 0.0065;
    joint.friction.law = CoulombViscous{0.04, 0.02};
    joint.control.k_p = 20, joint.control.k_v = 0.5, joint.control.V0 = 0.05;
    CHECK(steady_sliding(joint).deflection == Approx(0.041 / 20));
    joint.actuator.effort_gain = 0.5;
    CHECK(steady_sliding(joint).deflection == Approx(0.082 / 20));
    joint.actuator.kind = ActuatorKind::dc_motor, joint.actuator.effort_gain = 1;
    joint.actuator.k_t = joint.actuator.k_e = 0.3232, joint.actuator.resistance = 4.764;
    // 0.041 N·m take 0.126856 A, these 0.604344 V beside a back-EMF of 0.01616 V, at 20 V/rad
    CHECK(steady_sliding(joint).deflection == Approx(0.0310252).epsilon(1e-5));
}

TEST_CASE("a load that the loop carries is part of how far the joint is behind", "[stability][steady]")
{
    // an axis of 5 kg that moves down: 49.05 N pull it along, 8.16 N hold it back, and the spring of 20 kN/m the rest
    Joint joint;
    joint.mechanism.inertia = 5;
    joint.friction.law = CoulombViscous{8, 40};
    joint.control.k_p = 20e3, joint.control.k_v = 300, joint.control.V0 = -4e-3;
    joint.load.constant = -49.05;
    CHECK(steady_sliding(joint).deflection == Approx((49.05 - 8.16) / 20e3));
    CHECK(steady_sliding(joint).friction == Approx(-8.16));
}

TEST_CASE("The limit of the effort has to hold gravity where it pulls most and friction where it is warmest", "[loop]")
{
    // 60 N of friction and a pendulum of 20 N: 80 N against it, −60 + … never more to the other side
    Joint joint = example_joint(60e3, 10, 1e-3);
    joint.load.gravity_amplitude = 20, joint.load.gravity_phase = 0.3;
    joint.control.effort_limit = 80.1;
    CHECK(possible_sliding(joint).reason == Reason::none);
    joint.control.effort_limit = 79.9;
    CHECK(possible_sliding(joint).reason == Reason::limit_too_low);
    auto low = low_limit(joint, 1e-3);
    REQUIRE(low);
    CHECK(low->needed == Approx(80));
    // a pull that is larger than the friction brakes on the other side: 200 − 60 N, less than 260 N
    joint.load.gravity_amplitude = -200;
    joint.control.effort_limit = 250;
    low = low_limit(joint, 1e-3);
    REQUIRE(low);
    CHECK(low->needed == Approx(260));
    // 60 N, and 100 N more once it is warm
    joint.load = {};
    joint.friction.drift.change = 100;
    joint.control.effort_limit = 159;
    low = low_limit(joint, 1e-3);
    REQUIRE(low);
    CHECK(low->needed == Approx(160));
    joint.control.effort_limit = 161;
    CHECK_FALSE(low_limit(joint, 1e-3));
    joint.friction.drift.change = -100;
    joint.control.effort_limit = 61;
    CHECK_FALSE(low_limit(joint, 1e-3));
}

TEST_CASE("A limit that the effort of steady sliding stands at leaves no steady sliding to any theory", "[loop]")
{
    Joint joint = example_joint(60e3, 10, 1e-3);
    joint.control.effort_limit = 60;
    const auto low = low_limit(joint, 1e-3);
    REQUIRE(low);
    CHECK(low->needed == Approx(60));
    CHECK(possible_sliding(joint).reason == Reason::limit_too_low);
    CHECK(nonlinear_verdict(joint, {}).detail == Detail::effort_limit);
    joint.control.effort_limit = 60 * (1 + 1e-9);
    CHECK_FALSE(low_limit(joint, 1e-3));
}

TEST_CASE("A joint without a velocity has no limit to blame", "[loop]")
{
    Joint joint = example_joint(60e3, 10, 1e-3);
    joint.control.V0 = not_set;
    CHECK_FALSE(low_limit(joint, not_set));
    CHECK_FALSE(low_limit_at_rest(joint, not_set));
    joint.actuator.kind = ActuatorKind::dc_motor;
    joint.actuator.resistance = 1, joint.actuator.k_t = joint.actuator.k_e = 0.1;
    joint.actuator.supply_voltage = 24, joint.actuator.supply_resistance = 0.1;
    CHECK_FALSE(low_limit(joint, not_set));
}
