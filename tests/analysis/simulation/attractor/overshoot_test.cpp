// How far beyond the steady path a real loop swings, against a simulation of the same joint.
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/verdict.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace stickslip;

namespace {

/// A servo whose duty turns a motor on a supply that sags; its sliding at 50 mrad/s is unstable.
Joint sagging_servo()
{
    Joint joint;
    joint.mechanism.motion = Motion::revolute, joint.mechanism.inertia = 0.02;
    auto& a = joint.actuator;
    a.kind = ActuatorKind::dc_motor, a.signal = DriveSignal::duty;
    a.k_t = a.k_e = 0.3, a.resistance = 4.7, a.supply_voltage = 7.3, a.supply_resistance = 0.2;
    joint.control.k_p = 5, joint.control.k_v = 0.1, joint.control.V0 = 0.05;
    RateAndState law;
    law.f0 = 0.1, law.A = 0.005, law.V_star = 0.05;
    law.B.push_back(0.01), law.L.push_back(1e-3);
    joint.friction.law = law;
    return joint;
}

}  // namespace

TEST_CASE("The overshoot of a real loop is that of the cycle that a small disturbance grows to", "[sampled]")
{
    const Joint joint = sagging_servo();
    const auto verdict = nonlinear_verdict(joint, {});
    REQUIRE(is_set(verdict.period));
    REQUIRE(verdict.region == NonlinearRegion::stick_slip);
    SimulateOptions options;
    options.disturbance = {DisturbanceKind::offset, 3e-3};
    options.duration = 40 * verdict.period;
    const auto motion = simulate(joint, options);
    double peak = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i)
        if (motion.time[i] > 0.5 * options.duration) peak = std::max(peak, motion.position[i]);
    const double deflection = std::abs(linear_verdict(joint).steady.deflection);
    CHECK(verdict.overshoot * deflection == Approx(peak).epsilon(0.01));
}
