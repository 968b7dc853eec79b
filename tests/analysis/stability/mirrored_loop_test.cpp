// Joints that are each other's mirror image: the other way along the axis, or wired the other way round.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

using namespace stickslip;

namespace {

/// A small servo whose supply sags under its current.
Joint servo(double V0, DriveSignal signal)
{
    Joint joint = stribeck_joint(signal == DriveSignal::duty ? 4 : 44, signal == DriveSignal::duty ? 0.08 : 0.9, V0);
    joint.mechanism.motion = Motion::revolute;
    joint.mechanism.inertia = 0.011;
    joint.friction.law = Stribeck{.c0 = 0.16, .c1 = 0.06, .c2 = 0.09, .c3 = 0.2, .c4 = 1};
    auto& c = joint.control;
    c.period = 0.01, c.delay = 0.004, c.velocity_estimate.form = EstimateForm::backward_difference;
    auto& a = joint.actuator;
    a.kind = ActuatorKind::dc_motor, a.signal = signal;
    a.k_t = 1.45, a.k_e = 1.2, a.resistance = 4.8, a.supply_voltage = 11.1, a.supply_resistance = 1.5;
    return joint;
}

/// The same wires, the motor's exchanged and every gain with them.
Joint rewired(Joint joint)
{
    joint.actuator.effort_gain *= -1;
    auto& c = joint.control;
    c.k_p *= -1, c.k_v *= -1, c.k_i *= -1;
    return joint;
}

Joint delayed_loop(bool sampled)
{
    Joint joint = example_joint(80e3, 10, 1e-3);
    joint.control.delay = 2e-4;
    joint.control.k_i = 2e4;
    if (sampled) joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    return joint;
}

}  // namespace

TEST_CASE("A motor with a sagging supply is the same joint in both directions", "[loop]")
{
    for (const auto signal : {DriveSignal::voltage, DriveSignal::duty}) {
        for (const double load : {0.0, 0.3, -0.9}) {
            Joint there = servo(0.4, signal), back = servo(-0.4, signal);
            there.load.constant = load, back.load.constant = -load;
            const auto one = linear_verdict(there), other = linear_verdict(back);
            INFO("duty " << (signal == DriveSignal::duty) << " load " << load);
            CHECK(one.steady.reason == other.steady.reason);
            CHECK(other.state_variable.spectral_abscissa == Approx(one.state_variable.spectral_abscissa).epsilon(1e-9));
            REQUIRE(one.state_variable.stable_intervals.size() == 1);
            REQUIRE(other.state_variable.stable_intervals.size() == 1);
            CHECK(other.state_variable.stable_intervals[0].high ==
                  Approx(one.state_variable.stable_intervals[0].high).epsilon(1e-9));
        }
    }
}

TEST_CASE("A load that pulls a motor along asks for no more voltage than it takes", "[loop]")
{
    // 0.9 N·m forward against 0.25 of friction: the motor brakes with 0.65 N·m, which takes −2.2 V, and 1.5 V of
    // back-EMF
    Joint joint = servo(1.25, DriveSignal::voltage);
    joint.actuator.supply_resistance = 0;
    joint.friction.law = CoulombViscous{0.25, 0};
    joint.load.constant = 0.9;
    joint.control.effort_limit = 1;
    CHECK_FALSE(low_limit(joint, 1.25));
    joint.control.effort_limit = 0.6;
    const auto low = low_limit(joint, 1.25);
    REQUIRE(low);
    CHECK(low->needed == Approx(0.65 * 4.8 / 1.45 - 1.2 * 1.25));
}

TEST_CASE("A motor wired the other way has the windows of its gains on the other side of zero", "[loop]")
{
    for (const bool sampled : {true, false}) {
        const Joint joint = delayed_loop(sampled), other = rewired(joint);
        const auto own = linear_verdict(joint), mirrored = linear_verdict(other);
        INFO("sampled " << sampled);
        CHECK(mirrored.state_variable.stable);
        CHECK(mirrored.state_variable.spectral_abscissa == Approx(own.state_variable.spectral_abscissa));
        REQUIRE(own.state_variable.stable_intervals.size() == 1);
        REQUIRE(mirrored.state_variable.stable_intervals.size() == 1);
        CHECK(mirrored.state_variable.stable_intervals[0].low == Approx(-own.state_variable.stable_intervals[0].high));
        CHECK(mirrored.state_variable.stable_intervals[0].high == Approx(-own.state_variable.stable_intervals[0].low));
        REQUIRE(mirrored.velocity_only.stable_k_v.size() == own.velocity_only.stable_k_v.size());
        CHECK(own.velocity_only.stable_k_v.empty() == sampled);  // a hold of 1 ms leaves no k_v enough
        if (!sampled) CHECK(mirrored.velocity_only.stable_k_v[0].high == Approx(-own.velocity_only.stable_k_v[0].low));
    }
}

TEST_CASE("A motor wired the other way ends in the same region", "[loop][slow]")
{
    for (const bool sampled : {true, false}) {
        const Joint joint = delayed_loop(sampled);
        CHECK(nonlinear_verdict(rewired(joint), {}).region == nonlinear_verdict(joint, {}).region);
    }
}
