// Delayed friction is all the damping of a mass in a sampled loop: slow roots beside the integrator.
#include "analysis/stability/real_loop.h"
#include "analysis/stability/steady.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

using namespace stickslip;

namespace {

constexpr double period = 1.55e-3;
constexpr int steps_per_tick = 64, lag_steps = 355;  // of the integration below; the friction is 8.6 ms late

/// Joint 2234 of the consistency run, to three digits.
Joint mass_with_delayed_damping()
{
    Joint j;
    j.mechanism.motion = Motion::prismatic;
    j.mechanism.inertia = 0.17;
    j.control.k_p = 2.16e4, j.control.k_v = 995, j.control.V0 = 1e-2;
    j.control.period = period;
    j.control.velocity_estimate.form = EstimateForm::backward_difference;
    j.control.velocity_estimate.tau = 1.35e-4;
    j.actuator.lag = 3.73e-3, j.actuator.effort_gain = 0.757;
    j.sensor.position_scale = 0.137;
    TimeLag delayed;
    delayed.lag = lag_steps * period / steps_per_tick;
    CoulombViscous friction;
    friction.coulomb = 1, friction.viscous = 0.345;
    delayed.curve.law = friction;
    j.friction.law = delayed;
    return j;
}

RealLoop loop_of(const Joint& joint)
{
    const double velocity = sliding_velocity(joint);
    const auto loop = real_loop(joint, linear_joint(joint, velocity), velocity, TurnedGain::k_p);
    REQUIRE(loop);
    REQUIRE(std::holds_alternative<DelayedLoop>(loop->loop));
    return *loop;
}

/// Growth rate of a small motion of this loop about steady sliding, by Runge and Kutta's method of order 4 with the
/// velocities kept for the friction.
double stepped_growth(const Joint& j)
{
    using State = std::array<double, 3>;  // position, velocity, effort before its gain
    const double h = period / steps_per_tick, scale = j.sensor.position_scale, viscous = 0.345;
    std::vector<double> velocity(lag_steps + 1, 0.0);
    State y{1e-6, 0, 0};
    double command = 0, filtered = 0, before = y[0], first = 0, last = 0;
    constexpr int ticks = 20'000;
    for (int tick = 0; tick < ticks; ++tick) {
        const double& tau = j.control.velocity_estimate.tau;
        filtered += period / (tau + period) * (scale * (y[0] - before) / period - filtered);
        before = y[0];
        command = -(j.control.k_p * scale * y[0] + j.control.k_v * filtered);
        for (int i = 0; i < steps_per_tick; ++i) {
            const std::size_t delayed = velocity.size() - 1 - lag_steps;
            const auto rate = [&](const State& at, double share) {
                const double v = (1 - share) * velocity[delayed] + share * velocity[delayed + 1];
                return State{at[1], (j.actuator.effort_gain * at[2] - viscous * v) / j.mechanism.inertia,
                             (command - at[2]) / j.actuator.lag};
            };
            const auto moved = [&](const State& by, double part) {
                return State{y[0] + part * h * by[0], y[1] + part * h * by[1], y[2] + part * h * by[2]};
            };
            const State a = rate(y, 0), b = rate(moved(a, 0.5), 0.5), c = rate(moved(b, 0.5), 0.5),
                        d = rate(moved(c, 1), 1);
            for (std::size_t k = 0; k < y.size(); ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
            velocity.push_back(y[1]);
        }
        if (tick >= ticks / 4 && tick < ticks / 2) first = std::max(first, std::abs(y[1]));
        if (tick >= 3 * ticks / 4) last = std::max(last, std::abs(y[1]));
    }
    return std::log(last / first) / (0.5 * ticks * period);
}

}  // namespace

TEST_CASE("the growth of slow roots beside late damping is found at every gain, and its side by counts agrees",
          "[stability][late][slow]")
{
    const auto loop = loop_of(mass_with_delayed_damping());
    const auto& delayed = std::get<DelayedLoop>(loop.loop);
    for (double share = 1e-4; share < 3; share *= 1.1) {
        const double growth = delayed_growth(delayed, share * loop.gain),
                     side = delayed_side(delayed, share * loop.gain);
        INFO("k_p " << share * loop.gain << " growth " << growth << " side " << side);
        CHECK(std::isfinite(growth));
        CHECK((growth < 0) == (side < 0));
    }
}

TEST_CASE("gains that only late friction damps have their window", "[stability][late]")
{
    auto joint = mass_with_delayed_damping();
    const auto gains = turned_gains(loop_of(joint));
    REQUIRE(gains.stable.size() == 1);
    CHECK(gains.stable[0].low == 0);
    const double edge = gains.stable[0].high;
    for (const double share : {0.5, 0.999, 1.001, 2.0}) {
        joint.control.k_p = share * edge;
        CHECK((growth(loop_of(joint)) < 0) == (share < 1));
    }
    // and small motions grow or die out, integrated step by step
    for (const double share : {0.97, 1.03}) {
        joint.control.k_p = share * edge;
        const double stepped = stepped_growth(joint);
        CHECK((stepped < 0) == (share < 1));
        CHECK(stepped == Approx(growth(loop_of(joint))).epsilon(0.02));
    }
}
