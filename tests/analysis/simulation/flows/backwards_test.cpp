// A joint whose friction has no direction of its own moves backwards as it does forwards, mirrored.
#include "analysis/simulation/attractor/nonlinear.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

/// Two bodies, the motor's friction with a peak on which the link judders at 10 mrad/s.
Joint judders(double V0)
{
    Joint j;
    j.mechanism.model = Model::two_mass;
    j.mechanism.motor_inertia = 0.4, j.mechanism.link_inertia = 0.6;
    j.mechanism.transmission.stiffness = 9000, j.mechanism.transmission.damping = 6;
    j.control.k_p = 900, j.control.k_v = 40, j.control.V0 = V0;
    Stribeck motor;
    motor.c0 = 6, motor.c1 = 20, motor.c2 = 3, motor.c3 = 0.01, motor.c4 = 2;
    j.frictions.motor.law = motor;
    CoulombViscous link;
    link.coulomb = 1, link.viscous = 2;
    j.frictions.link.law = link;
    return j;
}

void check_mirrored(Joint forwards)
{
    Joint backwards = forwards;
    backwards.control.V0 *= -1;
    const auto a = nonlinear_verdict(forwards, {}), b = nonlinear_verdict(backwards, {});
    REQUIRE(a.outcome == Outcome::stick_slip);
    CHECK(b.outcome == a.outcome);
    CHECK(b.region == a.region);
    constexpr double by_ticks = 1e-2;  // turns begin at other places of a tick
    CHECK(b.amplitude == Approx(a.amplitude).epsilon(by_ticks));
    CHECK(b.overshoot == Approx(a.overshoot).epsilon(by_ticks));
    CHECK(b.velocity_min == Approx(-a.velocity_max).epsilon(by_ticks));
    CHECK(a.velocity_min == 0);
    CHECK(b.velocity_max == 0);
}

}  // namespace

TEST_CASE("motion backwards is that forwards, mirrored, in the ideal loop", "[simulation][backwards]")
{
    check_mirrored(judders(0.01));
}

TEST_CASE("motion backwards is that forwards, mirrored, in a sampled loop", "[simulation][backwards]")
{
    Joint j = judders(0.01);
    j.control.period = 1e-3;
    j.control.velocity_estimate.tau = 2e-3;
    check_mirrored(j);
    SECTION("behind an encoder")
    {
        j.sensor.encoder_quantum = 1e-5;
        check_mirrored(j);
    }
}

TEST_CASE("a stated disturbance is that of the joint, also of one that moves backwards", "[simulation][backwards]")
{
    Joint j;
    j.mechanism.inertia = 2;
    j.control.k_p = 2000, j.control.k_v = 20, j.control.V0 = 0.02;
    Stribeck law;
    law.c0 = 5, law.c1 = 10, law.c2 = 0.5, law.c3 = 0.03, law.c4 = 2;
    j.friction.law = law;
    NonlinearOptions along, against;
    along.disturbance = {DisturbanceKind::velocity, 0.01};
    against.disturbance = {DisturbanceKind::velocity, -0.01};
    const bool sampled = GENERATE(false, true);
    if (sampled) j.control.period = 1e-4;
    const auto ahead = nonlinear_verdict(j, along), behind = nonlinear_verdict(j, against);
    REQUIRE(ahead.overshoot > 1.2 * behind.overshoot);
    j.control.V0 = -0.02;
    const auto slower = nonlinear_verdict(j, along), faster = nonlinear_verdict(j, against);
    CHECK(faster.overshoot == Approx(ahead.overshoot));
    CHECK(slower.overshoot == Approx(behind.overshoot));
    CHECK(slower.disturbance.size == 0.01);
}

TEST_CASE("a state that deflects is disturbed with its sign", "[simulation][backwards]")
{
    Joint j;
    j.mechanism.inertia = 2;
    j.control.k_p = 2000, j.control.k_v = 20, j.control.V0 = 0.02;
    LuGre law;
    law.sigma0 = 1e5, law.sigma1 = 300, law.sigma2 = 10, law.coulomb = 5, law.breakaway = 5.2;
    law.stribeck_velocity = 0.5;
    j.friction.law = law;
    NonlinearOptions slacker, tenser;
    slacker.disturbance = {DisturbanceKind::state, -1e-5};
    tenser.disturbance = {DisturbanceKind::state, 1e-5};
    const auto forwards = nonlinear_verdict(j, slacker);
    REQUIRE(forwards.outcome == Outcome::stable_sliding);
    REQUIRE(forwards.overshoot > 0);
    REQUIRE(nonlinear_verdict(j, tenser).overshoot == 0);
    j.control.V0 = -0.02;
    CHECK(nonlinear_verdict(j, tenser).overshoot == Approx(forwards.overshoot));
}
