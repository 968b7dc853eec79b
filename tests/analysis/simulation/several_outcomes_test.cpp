// Which motions coexist, when turns count as repeats, and what is said where there is nothing to say.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "analysis/simulation/attractor/repeats.h"
#include "analysis/simulation/points.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

constexpr double sigma0 = 1e5, sigma1 = 316.2, sigma2 = 0.4, coulomb = 1, stiction = 1.5, stribeck_velocity = 1e-3;

Joint lugre_joint(double k_p, double V0)
{
    Joint joint = example_joint(k_p, 0, V0);
    LuGre law;
    law.sigma0 = sigma0, law.sigma1 = sigma1, law.sigma2 = sigma2;
    law.coulomb = coulomb, law.breakaway = stiction, law.stribeck_velocity = stribeck_velocity;
    joint.friction.law = law;
    return joint;
}

struct Swing {
    double amplitude = 0, period = 0;
};

/// The last of `turns` turns of the same mass in small fixed steps of the classical Runge-Kutta method.
Swing last_swing(double k_p, double V0, double pull, int turns)
{
    struct State {
        double x, V, z;
    };
    const auto level = [](double V) {
        return coulomb + (stiction - coulomb) * std::exp(-std::pow(V / stribeck_velocity, 2));
    };
    const double steady = level(V0) + sigma2 * V0, h = 4e-6;
    const auto rate = [&](State s) {
        const double slip = s.V - sigma0 * std::abs(s.V) * s.z / level(s.V);
        return State{s.V - V0, steady - sigma0 * s.z - sigma1 * slip - sigma2 * s.V - k_p * s.x, slip};
    };
    const auto moved = [](State s, double by, State r) {
        return State{s.x + by * r.x, s.V + by * r.V, s.z + by * r.z};
    };
    State s{pull, V0, level(V0) / sigma0};
    double t = 0, crossed = 0, low = 0, high = 0;
    Swing swing;
    for (int count = 0; count < turns; t += h) {
        const State a = rate(s), b = rate(moved(s, h / 2, a)), c = rate(moved(s, h / 2, b)), d = rate(moved(s, h, c));
        const double before = s.V;
        s = moved(moved(moved(moved(s, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
        low = std::min(low, s.x), high = std::max(high, s.x);
        if (!(before > V0 && s.V <= V0)) continue;
        const double now = t + h * (before - V0) / (before - s.V);
        swing = {(high - low) / 2, now - crossed};
        crossed = now, low = high = 0, ++count;
    }
    return swing;
}

}  // namespace

TEST_CASE("LuGre: the motion that a pull of the spring reaches is found beside steady sliding", "[nonlinear][slow]")
{
    for (const double V0 : {5e-3, 8e-3}) {
        CAPTURE(V0);
        const auto verdict = nonlinear_verdict(lugre_joint(1e4, V0), {});
        CHECK(verdict.outcome == Outcome::stable_sliding);
        CHECK(verdict.region == NonlinearRegion::bistable);
        const auto truth = last_swing(1e4, V0, 1e-4, 200);
        CHECK(verdict.amplitude == Approx(truth.amplitude).epsilon(1e-3));
        CHECK(verdict.period == Approx(truth.period).epsilon(1e-4));
    }
}

TEST_CASE("turns that come back in alternation are one motion, noise is none", "[nonlinear]")
{
    const auto repeat_of = [](const std::function<double(int)>& value) {
        const auto gap = [&](int i, int j) { return std::abs(value(i) - value(j)); };
        return turns_to_repeat(66, gap, 1e-5);
    };
    CHECK(repeat_of([](int i) { return 1 + 1e-3 * std::pow(-0.98, i); }) == 0);     // not there yet
    CHECK(repeat_of([](int i) { return 1 + 1e-2 * std::pow(-0.999, i); }) == 0);    // nor there for long
    CHECK(repeat_of([](int i) { return 1 + 1e-7 * std::sin(1e4 * i * i); }) == 1);  // the errors of the integrator
    CHECK(repeat_of([](int i) { return 1 + 1e-2 * (i % 2) + 1e-8 * std::sin(1e4 * i * i); }) == 2);
    CHECK(repeat_of([](int i) { return 1 + 1e-2 * (i % 3); }) == 3);
    // every second turn closes in alternating: not yet two, and never four
    CHECK(repeat_of([](int i) { return 1 + 1e-2 * (i % 2) + 2e-5 * std::pow(-0.97, i / 2); }) == 0);
    CHECK(repeat_of([](int i) { return 1 + 1e-7 * i; }) == 0);  // creeps on
}

TEST_CASE("a vibration of the transmission that a start from rest does not reach is found beside steady sliding",
          "[nonlinear][slow]")
{
    Joint joint = stribeck_joint(2108, 19.73, 6.9e-3);
    auto& m = joint.mechanism;
    m.model = Model::two_mass;
    m.motor_inertia = 4.24, m.link_inertia = 0.242;
    m.transmission.stiffness = 5.93e5, m.transmission.damping = 2.65;
    Stribeck link, motor;
    link.c0 = 2.39, link.c1 = 0.837, link.c2 = 0.165, link.c3 = 1.76e-3, link.c4 = 2;
    motor = link;
    motor.c0 = 1.77, motor.c2 = 0.0223, motor.c3 = 4.96e-3;
    joint.frictions.link.law = link, joint.frictions.motor.law = motor;
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.region == NonlinearRegion::bistable);
    // a push of the link that all but stops it, watched by the other solver
    SimulateOptions options;
    options.disturbance = {DisturbanceKind::impulse, -0.9 * m.link_inertia * 6.9e-3};
    options.duration = 3;
    options.fallback_only = true;
    const auto path = simulate(joint, options);
    double low = infinity, high = -infinity;
    for (std::size_t i = 0; i < path.time.size(); ++i)
        if (path.time[i] > 2.9) low = std::min(low, path.velocity[i]), high = std::max(high, path.velocity[i]);
    CHECK(verdict.velocity_max == Approx(high).epsilon(1e-2));
    CHECK(low == Approx(0).margin(1e-9));
    CHECK(verdict.velocity_min == Approx(0).margin(1e-9));
    options.disturbance = {DisturbanceKind::start, 0};
    CHECK(std::abs(simulate(joint, options).velocity.back() / 6.9e-3 - 1) < 0.1);
}

TEST_CASE("what keeps a joint from having an outcome has a code of its own, in sweeps, too", "[nonlinear]")
{
    const auto is_open = [](const Joint& joint, Reason why) {
        const auto verdict = nonlinear_verdict(joint, {});
        CHECK(verdict.outcome == Outcome::undecided);
        CHECK_FALSE(is_set(verdict.overshoot));
        CHECK(verdict.region != NonlinearRegion::bistable);
        CHECK(is_set(verdict.growth_rate) == (verdict.growth_missing == Detail::none));
        PointResult row = linear_point(joint);
        nonlinear_points({&joint, 1}, {}, {&row, 1});
        CHECK(row.reason == why);
        return verdict.reason == why;
    };
    CHECK(is_open(example_joint(-10, 0, 1e-3), Reason::diverges));
    CHECK(is_open(example_joint(0, 0, 1e-3), Reason::diverges));
    CHECK(is_open(example_joint(1e4, -1001, 1e-3), Reason::diverges));
    // a late loop runs away from a spring of 450 N/m and a damper of 5 N·s/m: no lack of either is said of it
    Joint late = stribeck_joint(450, 5, 1e-3);
    late.control.delay = 5e-3;
    late.control.k_i = 1e5;
    CHECK(nonlinear_verdict(late, {}).reason == Reason::diverges);
    Joint undamped = stribeck_joint(1e4, 0, 1e-3);
    undamped.friction.law = KineticStatic{8, 14};
    CHECK(is_open(undamped, Reason::neutral));
    Dahl dahl;
    dahl.coulomb = 10, dahl.sigma0 = 1e5, dahl.exponent = 1;
    undamped.friction.law = dahl;
    CHECK(is_open(undamped, Reason::neutral));
    Joint unset = example_joint(1e4, 0, 1e-3);
    unset.control.V0 = not_set;
    CHECK(is_open(unset, Reason::no_velocity));
    // but at its critical gain a joint with memory is decided by what is not linear
    CHECK(nonlinear_verdict(example_joint(55000, 0, 1e-3), {}).region == NonlinearRegion::stable);
}

TEST_CASE("late friction whose turns are shorter than its lag settles", "[nonlinear]")
{
    Joint joint = stribeck_joint(2e5, 0, 7.071067811865476e-4);
    Stribeck curve;
    curve.c0 = 10, curve.c1 = 0, curve.c2 = 0.1165822, curve.c3 = 1e-3;
    TimeLag law;
    law.lag = 5e-3;
    law.curve.law = curve;
    joint.friction.law = law;
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.region == NonlinearRegion::stable);
}
