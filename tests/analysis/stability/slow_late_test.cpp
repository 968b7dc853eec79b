// Friction that answers late is all the damping of a mass in a sampled loop: slow roots beside the integrator.
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace stickslip;

namespace {

CoulombViscous at_once()
{
    CoulombViscous friction;
    friction.coulomb = 1, friction.viscous = 0.345;
    return friction;
}

/// Joint 2234 of the consistency run, to three digits.
Joint mass_with_late_damping()
{
    Joint j;
    j.mechanism.motion = Motion::prismatic;
    j.mechanism.inertia = 0.17;
    j.control.k_p = 2.16e4, j.control.k_v = 995, j.control.V0 = 1e-2;
    j.control.period = 1.55e-3;
    j.control.velocity_estimate.form = EstimateForm::backward_difference;
    j.control.velocity_estimate.tau = 1.35e-4;
    j.actuator.lag = 3.73e-3;
    TimeLag late;
    late.lag = 8.6e-3;
    late.curve.law = at_once();
    j.friction.law = late;
    return j;
}

RealLoop loop_of(const Joint& joint)
{
    const double velocity = sliding_velocity(joint, commanded_velocity(joint));
    const auto loop = real_loop(joint, linear_joint(joint, velocity), velocity, TurnedGain::k_p);
    REQUIRE(loop);
    REQUIRE(std::holds_alternative<LateLoop>(loop->loop));
    return *loop;
}

}  // namespace

TEST_CASE("the growth of slow roots beside late damping is found at every gain, and its side by counts agrees",
          "[stability][late]")
{
    const auto loop = loop_of(mass_with_late_damping());
    const auto& late = std::get<LateLoop>(loop.loop);
    for (double share = 1e-4; share < 3; share *= 1.1) {
        const double growth = late_growth(late, share * loop.gain), side = late_side(late, share * loop.gain);
        INFO("k_p " << share * loop.gain << " growth " << growth << " side " << side);
        CHECK(std::isfinite(growth));
        CHECK((growth < 0) == (side < 0));
    }
}

TEST_CASE("gains that only late friction damps have their window", "[stability][late]")
{
    auto joint = mass_with_late_damping();
    const auto gains = turned_gains(loop_of(joint));
    REQUIRE(gains.stable.size() == 1);
    CHECK(gains.stable[0].low == 0);
    const double edge = gains.stable[0].high;
    for (const double share : {0.5, 0.999, 1.001, 2.0}) {
        joint.control.k_p = share * edge;
        CHECK((growth(loop_of(joint)) < 0) == (share < 1));
    }
    // the same loop with damping that answers at once, by its multipliers
    joint.friction.law = at_once();
    const double velocity = sliding_velocity(joint, commanded_velocity(joint));
    const auto prompt = real_loop(joint, linear_joint(joint, velocity), velocity, TurnedGain::k_p);
    REQUIRE(prompt);
    REQUIRE(std::holds_alternative<DiscreteLoop>(prompt->loop));
    CHECK(turned_gains(*prompt).stable[0].high == Approx(edge).epsilon(1e-3));
}
