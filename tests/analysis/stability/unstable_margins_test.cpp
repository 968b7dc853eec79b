// What an unstable loop lacks, and where a supply ends steady sliding.
#include "analysis/stability/resolution.h"
#include "analysis/stability/verdict.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

Joint sampled(double inertia, double k_p, double k_v)
{
    Joint joint;
    joint.mechanism.inertia = inertia;
    joint.control.k_p = k_p, joint.control.k_v = k_v, joint.control.V0 = 2e-3;
    joint.control.period = 1e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.friction.law = CoulombViscous{3, 20};
    return joint;
}

double growth_times(Joint joint, double factor)
{
    joint.control.k_p *= factor, joint.control.k_v *= factor;
    return growth_rate(joint);
}

}  // namespace

TEST_CASE("a loop that no common factor on its gains makes stable lacks no gain", "[stability][margins]")
{
    // friction falls with speed and the position alone is fed back: m s² − c s + k has a root to the right for every k
    Joint joint = sampled(10, 4e4, 0);
    joint.friction.law = Stribeck{3, 0, 2, 5e-3, 1};
    REQUIRE(growth_rate(joint) > 0);
    for (const double factor : {1e-6, 1e-3, 0.1, 10.0, 100.0}) REQUIRE(growth_times(joint, factor) > 0);
    CHECK(std::isnan(linear_verdict(joint).state_variable.gain_margin_db));
    joint.control.period = not_set, joint.control.delay = 1e-3;  // and by the roots of the continuous loop
    REQUIRE(growth_rate(joint) > 0);
    CHECK(std::isnan(linear_verdict(joint).state_variable.gain_margin_db));
}

TEST_CASE("a loop with too much gain lacks what brings it to its stable gains", "[stability][margins]")
{
    Joint joint = sampled(1, 2e6, 4e3);
    REQUIRE(growth_rate(joint) > 0);
    const double db = linear_verdict(joint).state_variable.gain_margin_db;
    REQUIRE(db < 0);
    const double factor = std::pow(10, db / 20);
    CHECK(growth_times(joint, 0.999 * factor) < 0);
    CHECK(growth_times(joint, 1.001 * factor) > 0);
}

TEST_CASE("stable velocities end where the supply of a motor does, not at a place of the scan", "[stability]")
{
    constexpr double supply = 24, k_t = 0.8, k_e = 0.8, resistance = 2, level = 3;
    Joint joint = sampled(0.5, 200, 3);
    joint.friction.law = CoulombViscous{level, 0};
    auto& a = joint.actuator;
    a.kind = ActuatorKind::dc_motor;
    a.k_t = k_t, a.k_e = k_e, a.resistance = resistance, a.supply_voltage = supply;
    joint.control.V0 = 2;
    const auto found = stable_velocities(joint, 0.1, 300, Theory::state_variable);
    REQUIRE(!found.intervals.empty());
    CHECK(found.intervals.back().high == Approx((supply - level * resistance / k_t) / k_e).epsilon(1e-8));
}
