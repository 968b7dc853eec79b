// Delayed friction: the windows of stable gains and the growth between them, by simulation.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

/// A curve of slope −100 N·s/m at V_0 = 1 mm/s under 1 kg, 5 ms late.
Joint delayed_joint(double k_p, double k_v)
{
    Joint joint = stribeck_joint(k_p, k_v, 1e-3);
    Stribeck curve;
    curve.c0 = 8, curve.c1 = 0, curve.c2 = 0.5, curve.c3 = 2e-3;
    // −f_ss'(V_0) = 2 c2 V_0/c3² exp(−(V_0/c3)²), scaled to 100
    curve.c2 *= 100 / (2 * curve.c2 * 1e-3 / 4e-6 * std::exp(-0.25));
    TimeLag law;
    law.lag = 5e-3;
    law.curve.law = curve;
    joint.friction.law = law;
    return joint;
}

Joint lag_joint(double inertia, double k_p, double k_v, double V0, double lag, const Stribeck& curve)
{
    Joint joint = stribeck_joint(k_p, k_v, V0);
    joint.mechanism.inertia = inertia;
    TimeLag law;
    law.lag = lag;
    law.curve.law = curve;
    joint.friction.law = law;
    return joint;
}

/// One downward crossing of V_0.
struct Crossing {
    double t, x;
};

/// The same motion by Heun's method in fixed steps, with friction of the Gaussian curve and true sticking.
std::vector<Crossing> by_small_steps(double m, double k_p, double V0, double lag, const Stribeck& c, double duration)
{
    constexpr int steps_per_lag = 3000;
    const double h = lag / steps_per_lag;
    const auto curve = [&](double V) { return c.c0 + c.c1 * V + c.c2 * std::exp(-std::pow(V / c.c3, 2)); };
    const double steady = curve(V0), highest = c.c0 + c.c2;
    std::vector<double> speed(steps_per_lag + 1, V0);
    std::vector<Crossing> crossings;
    double x = 0.1 * V0 * std::sqrt(m / k_p), V = V0;
    for (int i = 0; i * h < duration; ++i) {
        const double then = speed[speed.size() - 1 - steps_per_lag], next = speed[speed.size() - steps_per_lag];
        if (V == 0 && steady - k_p * x < highest) {
            x -= V0 * h;
        } else {
            const double a = (steady - curve(then) - k_p * x) / m;
            const double xe = x + h * (V - V0), Ve = V + h * a;
            const double b = (steady - curve(next) - k_p * xe) / m, before = V;
            x += h * ((V + Ve) / 2 - V0);
            V = std::max(0.0, V + h * (a + b) / 2);
            if (before > V0 && V <= V0) crossings.push_back({i * h, x});
        }
        speed.push_back(V);
    }
    return crossings;
}

}  // namespace

TEST_CASE("time lag: windows of stable gains, by the method of steps", "[nonlinear]")
{
    // m = 1, |f'| = 100, τ = 5 ms, k_v = 0: stable for 130112 < k_p < 794017 N/m; k_v = 50: from 62003 on
    NonlinearOptions options;
    options.region = false;
    const auto outcome = [&](double k_p, double k_v) {
        return nonlinear_verdict(delayed_joint(k_p, k_v), options).outcome;
    };
    CHECK(outcome(0.95 * 130112, 0) != Outcome::stable_sliding);
    CHECK(outcome(1.05 * 130112, 0) == Outcome::stable_sliding);
    CHECK(outcome(0.97 * 794017, 0) == Outcome::stable_sliding);
    CHECK(outcome(1.03 * 794017, 0) != Outcome::stable_sliding);
    CHECK(outcome(0.95 * 62003, 50) != Outcome::stable_sliding);
    CHECK(outcome(1.05 * 62003, 50) == Outcome::stable_sliding);
}

TEST_CASE("time lag: the measured growth solves the characteristic equation", "[nonlinear]")
{
    // m s² + (k_v − |f'| e^{−sτ}) s + k_p = 0 for the pair near i √(k_p/m), by Newton
    for (const double k_p : {5e4, 2e5, 9e5}) {
        std::complex<double> s(0, std::sqrt(k_p));
        for (int i = 0; i < 50; ++i) {
            const auto delayed = 100.0 * std::exp(-s * 5e-3);
            s -= (s * s - delayed * s + k_p) / (2.0 * s - delayed + 5e-3 * delayed * s);
        }
        NonlinearOptions options;
        options.region = false;
        CAPTURE(k_p, s.imag());
        CHECK(nonlinear_verdict(delayed_joint(k_p, 0), options).growth_rate == Approx(s.real()).epsilon(1e-5));
    }
}

TEST_CASE("time lag: growth of the slowest mode among many that are nearly as slow", "[nonlinear]")
{
    Stribeck curve;
    curve.c0 = 6.7, curve.c1 = 0.078, curve.c2 = 0.084, curve.c3 = 2e-4, curve.c4 = 1;
    const Joint joint = lag_joint(0.23, 16300, 509, 1.5e-3, 10e-3, curve);
    const auto linear = linear_verdict(joint).state_variable;
    REQUIRE(linear.stable);
    NonlinearOptions options;
    options.region = false;
    const auto verdict = nonlinear_verdict(joint, options);
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.growth_rate == Approx(linear.spectral_abscissa).epsilon(1e-5));
}

TEST_CASE("time lag: a motion that repeats after two turns, against small fixed steps", "[nonlinear]")
{
    Stribeck curve;
    curve.c0 = 1.26, curve.c1 = 41, curve.c2 = 9.17, curve.c3 = 0.02, curve.c4 = 2;
    const double m = 0.0362, k_p = 103600, V0 = 0.0207, lag = 4.96e-3;
    const auto crossings = by_small_steps(m, k_p, V0, lag, curve, 1.0);
    REQUIRE(crossings.size() > 40);
    const auto& last = crossings.back();
    const auto& one_before = crossings[crossings.size() - 2];
    const auto& two_before = crossings[crossings.size() - 3];
    CHECK(last.x == Approx(two_before.x).epsilon(1e-3));
    CHECK(std::abs(last.x - one_before.x) > 0.1 * std::abs(last.x));
    const auto verdict = nonlinear_verdict(lag_joint(m, k_p, 0, V0, lag, curve), {});
    CHECK(verdict.outcome == Outcome::period_n);
    CHECK(verdict.repeats == 2);
    CHECK(verdict.period == Approx(last.t - two_before.t).epsilon(1e-3));
}

TEST_CASE("a phase of sticking that outlasts ten thousand swings is no reason to give up", "[nonlinear]")
{
    // the spring winds up at V_0 for 2 c2/(k_p V_0) = 45 s, sixty thousand periods of the mass on its spring
    Joint joint = stribeck_joint(6e4, 0, 1.1e-5);
    joint.mechanism.inertia = 0.33;
    Stribeck law;
    law.c0 = 0.34, law.c1 = 0.44, law.c2 = 15, law.c3 = 1.6e-3, law.c4 = 2;
    joint.friction.law = law;
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::stick_slip);
    CHECK(verdict.stick_fraction == Approx(1).epsilon(1e-3));
}

TEST_CASE("what rounding leaves of a rest is no motion backwards", "[nonlinear]")
{
    const Joint joint = lag_joint(1, 60e3, 10, 1e-3, 1e-3, {60, 10, 6, 2e-3, 2});
    const NonlinearVerdict v = nonlinear_verdict(joint, {});
    REQUIRE(v.outcome == Outcome::stick_slip);
    CHECK(v.velocity_min == 0);
}
