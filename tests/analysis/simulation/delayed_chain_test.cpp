// Delayed friction on joints of several bodies and through reversal: against small fixed steps, against the
// linear spectrum, and in the limit of a stiff transmission against the single mass.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

FrictionLaw delayed(double lag, CurveLaw curve)
{
    TimeLag law;
    law.lag = lag;
    law.curve.law = std::move(curve);
    return law;
}

Stribeck stribeck(double c0, double c1, double c2, double c3)
{
    Stribeck law;
    law.c0 = c0, law.c1 = c1, law.c2 = c2, law.c3 = c3, law.c4 = 2;
    return law;
}

FrictionLaw no_friction()
{
    CoulombViscous law;
    law.coulomb = 0, law.viscous = 0;
    return law;
}

Joint one_mass(double inertia, double k_p, double V0, FrictionLaw law)
{
    Joint joint = stribeck_joint(k_p, 0, V0);
    joint.mechanism.inertia = inertia;
    joint.friction.law = std::move(law);
    return joint;
}

Joint two_masses(double motor, double link, double stiffness, double damping, double k_p, double V0,
                 FrictionLaw motor_law, FrictionLaw link_law)
{
    Joint joint = stribeck_joint(k_p, 0, V0);
    auto& m = joint.mechanism;
    m.model = Model::two_mass;
    m.motor_inertia = motor, m.link_inertia = link;
    m.transmission.stiffness = stiffness, m.transmission.damping = damping;
    joint.frictions.motor.law = std::move(motor_law);
    joint.frictions.link.law = std::move(link_law);
    return joint;
}

/// What a motion does in its last turns.
struct Swing {
    double amplitude, period, least_speed;
};

/// Heun's method in fixed steps for a motor on a spring k_p and a link behind a spring k (of no mass and no length
/// where `motor` is 0), friction on the link alone: its level from |V| a lag ago, its direction that of the motion now.
Swing by_small_steps(double motor, double link, double k, double damping, double k_p, double V0, double lag,
                     const std::function<double(double)>& curve, double at_rest, double start, double duration,
                     int steps_per_lag)
{
    const double h = lag / steps_per_lag, steady = curve(V0);
    struct State {
        double xm, x, vm, v;  // relative to the steady path, where the springs carry the steady friction
    };
    std::vector<double> speed(static_cast<std::size_t>(steps_per_lag) + 1, V0);
    State s{start, start, V0, V0};
    const auto pull = [&](const State& y) {
        return motor > 0 ? k * (y.xm - y.x) + damping * (y.vm - y.v) : -k_p * y.x;
    };
    int direction = 1;
    const auto rate = [&](const State& y, double then) {
        State r{};
        const double force = steady + pull(y);
        r.xm = y.vm - V0, r.x = y.v - V0;
        r.vm = motor > 0 ? (-k_p * y.xm - pull(y)) / motor : 0;
        r.v = direction == 0 ? 0 : (force - direction * curve(std::abs(then))) / link;
        return r;
    };
    const auto moved = [](const State& a, double by, const State& r) {
        return State{a.xm + by * r.xm, a.x + by * r.x, a.vm + by * r.vm, a.v + by * r.v};
    };
    std::vector<double> crossings;
    double low = 1e300, high = -1e300, slowest = V0;
    const auto n = static_cast<std::size_t>(steps_per_lag);
    for (int i = 0; i * h < duration; ++i) {
        const double then = speed[speed.size() - 1 - n], next = speed[speed.size() - n];
        if (direction == 0) {
            const double force = steady + pull(s), limit = std::max(at_rest, curve(std::abs(then)));
            if (std::abs(force) > limit) direction = force > 0 ? 1 : -1;
        }
        const State r = rate(s, then), e = moved(s, h, r), r2 = rate(e, next), before = s;
        s = moved(moved(s, h / 2, r), h / 2, r2);
        if (direction == 0) s.v = 0;
        if (direction != 0 && s.v * direction < 0) {  // comes to rest, and there turns back or stays
            s.v = 0;
            const double force = steady + pull(s);
            direction = std::abs(force) <= std::max(at_rest, curve(std::abs(next))) ? 0 : force > 0 ? 1 : -1;
        }
        if (before.v > V0 && s.v <= V0) crossings.push_back(i * h + h * (before.v - V0) / (before.v - s.v));
        if (i * h > 0.8 * duration) {
            low = std::min(low, s.x), high = std::max(high, s.x);
            slowest = std::min(slowest, s.v);
        }
        speed.push_back(s.v);
    }
    const auto last = crossings.size() - 1;
    return {(high - low) / 2, (crossings[last] - crossings[last - 4]) / 4, slowest};
}

}  // namespace

TEST_CASE("time lag behind a stiff transmission: the single mass", "[nonlinear]")
{
    const auto law = delayed(5e-3, stribeck(8, 0, 0.6, 2e-3));
    const auto single = nonlinear_verdict(one_mass(1, 6e4, 1e-3, law), {});
    const auto chain = nonlinear_verdict(two_masses(0.4, 0.6, 3e9, 3e3, 6e4, 1e-3, no_friction(), law), {});
    CHECK(single.outcome == Outcome::stick_slip);
    CHECK(chain.outcome == single.outcome);
    CHECK(chain.region == single.region);
    CHECK(chain.growth_rate == Approx(single.growth_rate).epsilon(1e-3));
    CHECK(chain.period == Approx(single.period).epsilon(1e-3));
    CHECK(chain.amplitude == Approx(single.amplitude).epsilon(1e-3));
    CHECK(chain.path == DecisionPath::steps);
}

TEST_CASE("time lag on some of several bodies: measured growth against the spectrum with delays", "[nonlinear]")
{
    constexpr unsigned seed = 20261121;
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
    };
    RateAndState slip;
    slip.f0 = 20, slip.A = 0.5, slip.V_star = 1e-3;
    slip.B.push_back(0.6), slip.L.push_back(2e-5);
    NonlinearOptions options;
    options.region = false;
    int measured = 0;
    for (int i = 0; i < 12; ++i) {
        const double V0 = between(1e-3, 1e-2);
        const auto law =
            delayed(between(1e-3, 2e-2), stribeck(6, between(0.1, 20), between(0.1, 1), between(1, 4) * V0));
        const FrictionLaw other = i % 3 == 0   ? law
                                  : i % 3 == 1 ? FrictionLaw(stribeck(2, 10, 0.1, 2 * V0))
                                               : FrictionLaw(slip);
        const bool on_link = i % 2 == 0;
        const Joint joint = two_masses(between(0.2, 2), between(0.5, 2), between(1e4, 1e6), between(1, 100),
                                       between(1e3, 1e5), V0, on_link ? other : law, on_link ? law : other);
        const auto linear = linear_verdict(joint).state_variable;
        const double growth = nonlinear_verdict(joint, options).growth_rate;
        CAPTURE(seed, i, linear.spectral_abscissa);
        if (!is_set(growth)) continue;
        ++measured;
        CHECK(growth == Approx(linear.spectral_abscissa).epsilon(2e-5));
    }
    CHECK(measured >= 10);
}

TEST_CASE("time lag behind a soft transmission, with sticking, against small fixed steps", "[nonlinear]")
{
    const auto curve = stribeck(8, 0, 0.6, 2e-3);
    const auto truth = by_small_steps(
        0.4, 0.6, 2e5, 20, 3e4, 1e-3, 5e-3, [&](double V) { return curve.steady_force(std::max(V, 1e-12)); }, 8.6, 1e-6,
        4, 4000);
    const auto verdict =
        nonlinear_verdict(two_masses(0.4, 0.6, 2e5, 20, 3e4, 1e-3, no_friction(), delayed(5e-3, curve)), {});
    CHECK(verdict.outcome == Outcome::stick_slip);
    CHECK(verdict.period == Approx(truth.period).epsilon(1e-3));
    CHECK(verdict.amplitude == Approx(truth.amplitude).epsilon(1e-3));
}

TEST_CASE("time lag: what turns back is followed through reversal, against small fixed steps", "[nonlinear][slow]")
{
    // at V = 0 the spring pulls with about m ω V_0 = 1 N, which a static friction of 0.55 N cannot hold
    const auto curve = stribeck(0.05, 0, 0.5, 0.02);
    const auto truth = by_small_steps(
        0, 1, 0, 0, 1e4, 1e-2, 1e-3, [&](double V) { return curve.steady_force(std::max(V, 1e-14)); }, 0.55, 1e-5, 8,
        2000);
    const auto verdict = nonlinear_verdict(one_mass(1, 1e4, 1e-2, delayed(1e-3, curve)), {});
    CHECK(truth.least_speed < 0);
    CHECK(verdict.outcome == Outcome::reversal);
    CHECK(verdict.reason == Reason::none);
    CHECK(verdict.period == Approx(truth.period).epsilon(1e-3));
    CHECK(verdict.amplitude == Approx(truth.amplitude).epsilon(1e-3));
    CHECK(verdict.velocity_min == Approx(truth.least_speed).epsilon(1e-2));
}

TEST_CASE("time lag on the steady curve of LuGre: held at rest, and followed through reversal", "[nonlinear][slow]")
{
    const auto check = [](double coulomb, double breakaway, double stribeck_velocity, double k_p, double V0,
                          double lag) {
        LuGre law;
        law.sigma0 = 1e5, law.sigma1 = 316, law.sigma2 = 0;
        law.coulomb = coulomb, law.breakaway = breakaway, law.stribeck_velocity = stribeck_velocity;
        const auto curve = [&](double V) { return law.steady_force(std::max(V, 1e-15)); };
        const auto truth = by_small_steps(0, 1, 0, 0, k_p, V0, lag, curve, breakaway, V0 / 63, 8, 2000);
        const auto verdict = nonlinear_verdict(one_mass(1, k_p, V0, delayed(lag, law)), {});
        CAPTURE(V0, truth.least_speed);
        CHECK(verdict.outcome == (truth.least_speed < 0 ? Outcome::reversal : Outcome::stick_slip));
        CHECK(verdict.period == Approx(truth.period).epsilon(2e-3));
        CHECK(verdict.amplitude == Approx(truth.amplitude).epsilon(2e-3));
        return truth.least_speed;
    };
    CHECK(check(1, 1.5, 1e-3, 4e3, 1e-3, 2e-3) == 0);
    CHECK(check(0.05, 0.55, 0.02, 1e4, 1e-2, 1e-3) < 0);
}

TEST_CASE("time lag on several bodies: the trajectory ends where the verdict says", "[nonlinear]")
{
    const Joint joint =
        two_masses(0.4, 0.6, 2e5, 20, 3e4, 1e-3, no_friction(), delayed(5e-3, stribeck(8, 0, 0.6, 2e-3)));
    SimulateOptions options;
    options.duration = 6;
    options.disturbance.size = 1e-6;
    const auto path = simulate(joint, options);
    REQUIRE(path.reason == Reason::none);
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < path.time.size(); ++i)
        if (path.time[i] > 5) low = std::min(low, path.position[i]), high = std::max(high, path.position[i]);
    CHECK((high - low) / 2 == Approx(nonlinear_verdict(joint, {}).amplitude).epsilon(1e-3));
}
