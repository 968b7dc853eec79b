// Joints whose inertia outweighs friction a thousand times (V_0 from some 0.1 m/s on) and joints at their boundary: one
// turn changes next to nothing, so that the errors of a turn must not decide.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/verdict.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

constexpr double beta = 1.5;

/// Work per turn of the slip law, in units of A V_0, when the speed is made to be V_0 (1 + a cos φ) with φ = ωt, and
/// the state has settled: Runge-Kutta on θ alone. `omega` is in units of V_0/L.
double work_of_turn(double a, double omega)
{
    constexpr int steps = 1000, turns = 6;
    const double h = 2 * std::numbers::pi / steps;
    const auto w = [a](double phi) { return std::log1p(a * std::cos(phi)); };
    const auto rate = [&](double phi, double p) { return -(1 + a * std::cos(phi)) * (p + beta * w(phi)) / omega; };
    double p = 0, work = 0;
    for (int i = 0; i < turns * steps; ++i) {
        const double phi = h * (i % steps);
        if (i >= (turns - 1) * steps) work += h * (w(phi) + p) * a * std::cos(phi);
        const double k1 = rate(phi, p), k2 = rate(phi + h / 2, p + h / 2 * k1);
        const double k3 = rate(phi + h / 2, p + h / 2 * k2), k4 = rate(phi + h, p + h * k3);
        p += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return work;
}

/// The amplitude at which friction takes and gives the same: the cycle of an infinitely heavy mass whose gain is that
/// share of the critical one, K = share · (β − 1) M.
double amplitude_of_heavy_mass(double share)
{
    const double omega = std::sqrt(share * (beta - 1));
    double small = 1e-3, large = 0.999;
    for (int i = 0; i < 25; ++i) {
        const double middle = 0.5 * (small + large);
        (work_of_turn(middle, omega) < 0 ? small : large) = middle;
    }
    return 0.5 * (small + large);
}

double critical_gain(double V0)
{
    return 0.5e5 * (1 + 1e5 * V0 * V0);
}

}  // namespace

TEST_CASE("the cycle of a heavy mass is the one in which friction does no work", "[nonlinear]")
{
    // the second speed once ended in "both solvers failed", as a trial amplitude brought V below what doubles hold
    for (const double V0 : {1.0, 0.3})
        for (const double share : {0.99, 0.5, 0.1}) {
            CAPTURE(V0, share);
            const double k_p = share * critical_gain(V0);
            const auto verdict = nonlinear_verdict(example_joint(k_p, 0, V0), {});
            REQUIRE(verdict.outcome == Outcome::limit_cycle);
            const double a = amplitude_of_heavy_mass(share);
            CHECK((verdict.velocity_max - verdict.velocity_min) / (2 * V0) == Approx(a).epsilon(2e-3));
            CHECK(verdict.amplitude == Approx(a * V0 / std::sqrt(k_p)).epsilon(2e-3));
            CHECK(verdict.period == Approx(2 * std::numbers::pi / std::sqrt(k_p)).epsilon(1e-3));
        }
}

TEST_CASE("above the boundary of a supercritical joint everything decays, however slowly", "[nonlinear][slow]")
{
    for (const double V0 : {1.0, 0.1, 1e-2, 1e-5})
        for (const double excess : {1e-6, 1e-3}) {
            CAPTURE(V0, excess);
            const auto verdict = nonlinear_verdict(example_joint(critical_gain(V0) * (1 + excess), 0, V0), {});
            CHECK(verdict.outcome == Outcome::stable_sliding);
            CHECK(verdict.region != NonlinearRegion::bistable);
        }
}

TEST_CASE("a growth rate is right to 1e-5 or not given", "[nonlinear][slow]")
{
    int given = 0;
    for (const double V0 : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5})
        for (const double share : {0.3, 0.999, 1.00001, 1.5}) {
            CAPTURE(V0, share);
            const auto joint = example_joint(share * critical_gain(V0), 0, V0);
            NonlinearOptions options;
            options.region = false;
            const double rate = nonlinear_verdict(joint, options).growth_rate;
            if (std::isnan(rate)) continue;
            ++given;
            CHECK(rate == Approx(linear_verdict(joint).state_variable.spectral_abscissa).epsilon(1e-5));
        }
    CHECK(given >= 18);
    // k_v V_0 is all but B − A, and friction far outweighs inertia: a thousandth of V_0 is no small disturbance
    Joint bent = example_joint(0.99635, 18317.5, 0.000112123);
    bent.mechanism.inertia = 5.70714;
    auto& law = std::get<RateAndState>(bent.friction.law);
    law.A = 1.45683, law.B[0] = 3.51071, law.L[0] = 3.67484e-05;
    const double abscissa = linear_verdict(bent).state_variable.spectral_abscissa;
    CHECK(nonlinear_verdict(bent, {}).growth_rate == Approx(abscissa).epsilon(1e-5));
}

TEST_CASE("a stiff cycle is as fast as its path, not as the cubic through its slopes", "[nonlinear]")
{
    // hardly any direct effect beside k_v: a slip begins within 1e-5 of the period; the cubic's turning point was 1e35
    // m/s
    Joint joint = with_ageing(example_joint(0.99635000543787822, 18317.477110914038, 1.1212277725147788e-4));
    joint.mechanism.inertia = 5.7071444922437964;
    auto& law = std::get<Ageing>(joint.friction.law);
    law.A = 1.4568305229495966, law.B[0] = 3.5107061301192601, law.L[0] = 3.6748428467122162e-05;
    const auto verdict = nonlinear_verdict(joint, {});
    REQUIRE(verdict.outcome == Outcome::stick_slip);
    // by the lanes, whose steps, equations and extremes are their own
    CHECK(verdict.velocity_max == Approx(2.00509e-3).epsilon(1e-3));
    CHECK(verdict.velocity_min == Approx(5.05544e-15).epsilon(1e-2));
}
