// The critical gain: published numbers, closed form against spectrum, two states.
#include <catch2/catch.hpp>
#include <random>

#include "analysis/joint/parameters.h"
#include "analysis/stability/crossings.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/verdict.h"

using namespace stickslip;

namespace {

Joint slip_law_joint(double m, double k_p, double k_v, double V0, double A, double B, double L)
{
    Joint joint;
    joint.mechanism.inertia = m;
    joint.control.k_p = k_p;
    joint.control.k_v = k_v;
    joint.control.V0 = V0;
    RateAndState law;
    law.f0 = 60;
    law.A = A;
    law.B.push_back(B);
    law.L.push_back(L);
    law.V_star = 1e-3;
    joint.friction.law = law;
    return joint;
}

/// k_cr by nothing but the spectrum: bisection on the sign of max Re s over a bracket that does not know the closed
/// form.
double critical_gain_by_spectrum(LinearMass mass)
{
    double low = 1e-30, high = 1e30;
    for (int i = 0; i < 400 && high / low > 1 + 1e-14; ++i) {
        mass.k_p = std::sqrt(low) * std::sqrt(high);
        (spectral_abscissa(mass) < 0 ? high : low) = mass.k_p;
    }
    return std::sqrt(low) * std::sqrt(high);
}

}  // namespace

TEST_CASE("critical gain and frequency of the three joints with known numbers", "[stability]")
{
    // closed form confirmed by eigenvalues outside this program: m, k_v, V_0, k_cr, ω at A = 1, B = 1.5, L = 1e-5
    struct Known {
        double m, k_v, V0, k_cr, omega;
    };
    for (const auto& k :
         {Known{1, 0, 1e-3, 55000, 70.71067811865474}, Known{2, 100, 1e-3, 47272.727272727, 60.30226891555271},
          Known{1, 0, 1e-2, 550000, 707.1067811865474}}) {
        const auto verdict = linear_verdict(slip_law_joint(k.m, 2e4, k.k_v, k.V0, 1, 1.5, 1e-5)).state_variable;
        CHECK(verdict.k_cr == Approx(k.k_cr).epsilon(1e-11));
        REQUIRE(verdict.crossings.size() == 1);
        CHECK(verdict.crossings[0].omega == Approx(k.omega).epsilon(1e-12));
        CHECK(verdict.crossings[0].direction == -1);
        CHECK(verdict.stable_intervals.size() == 1);
    }
}

TEST_CASE("closed form and spectrum agree to 1e-9 for random joints", "[stability]")
{
    constexpr unsigned seed = 20260101;
    std::mt19937_64 random(seed);
    INFO("seed " << seed);
    const auto log_uniform = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<>(0, 1)(random));
    };
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const double M = log_uniform(1e-7, 1e3), A = log_uniform(1e-3, 1e3), L = log_uniform(1e-8, 1e-2),
                     V0 = log_uniform(1e-9, 1);
        const double B = A * (1 + log_uniform(1e-2, 1e2)), m = M * L * A / (V0 * V0);
        const double k_v = std::uniform_real_distribution<>(0, 0.95)(random) * (B - A) / V0;
        const auto joint = slip_law_joint(m, 1, k_v, V0, A, B, L);
        const double closed = linear_point(joint).k_cr;
        const double by_spectrum = critical_gain_by_spectrum(linear_mass(joint, V0));
        const double deviation = std::abs(closed / by_spectrum - 1);
        worst = std::max(worst, deviation);
        if (!(deviation < 1e-9)) {
            CAPTURE(M, A, B, L, V0, k_v, closed, by_spectrum);
            REQUIRE(deviation < 1e-9);
        }
    }
    CAPTURE(worst);
    CHECK(worst < 1e-9);
}

TEST_CASE("the roots solve the characteristic equation", "[stability]")
{
    std::mt19937_64 random(7);
    const auto power = [&](double low, double high) {
        return std::pow(10, std::uniform_real_distribution<>(low, high)(random));
    };
    for (int i = 0; i < 2000; ++i) {
        const auto joint = slip_law_joint(power(-4, 4), power(0, 8), power(-2, 4), power(-6, -1), power(-2, 2),
                                          power(-2, 2), power(-7, -3));
        const auto mass = linear_mass(joint, joint.control.V0);
        const auto roots = spectrum(mass);
        REQUIRE(roots.size() == 3);
        for (const auto& s : roots) {
            // how far s is from the root: |F/F'|, since F alone is as steep as you like beside the pole of G
            const double gap = mass.friction.lambda[0], weight = mass.friction.weight(0);
            const auto G = transfer(mass.friction, s), G_slope = -weight / ((s - gap) * (s - gap));
            const auto C = mass.k_v + mass.friction.f_v - G;
            const auto distance =
                std::abs(((mass.inertia * s + C) * s + mass.k_p) / (2.0 * mass.inertia * s + C - G_slope * s));
            CHECK(distance < 1e-9 * std::abs(s));
        }
    }
}

TEST_CASE("two states without inertia have the critical stiffness of Gu, Rice, Ruina and Tse", "[stability]")
{
    // dimensionless A = V = L_1 = 1, β = 1 and 0.84, ρ = L_1/L_2 = 0.048: κ_cr = 0.0802755656 (1984)
    Joint joint = slip_law_joint(1e-12, 0.05, 0, 1, 1, 1, 1);
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.B.push_back(0.84);
    law.L.push_back(1 / 0.048);
    const auto verdict = linear_verdict(joint).state_variable;
    CHECK(verdict.k_cr == Approx(0.0802755656).epsilon(1e-9));
    CHECK(verdict.crossings.size() == 1);
    CHECK(critical_gain_by_spectrum(linear_mass(joint, 1)) == Approx(0.0802755656).epsilon(1e-9));
}

TEST_CASE("where the closed form has no critical gain the stable set is all or nothing", "[stability]")
{
    const auto damped =
        linear_verdict(slip_law_joint(1, 10, 600, 1e-3, 1, 1.5, 1e-5)).state_variable;  // k_v > (B − A)/V_0 = 500
    CHECK(std::isnan(damped.k_cr));
    REQUIRE(damped.stable_intervals.size() == 1);
    CHECK(damped.stable_intervals[0].low == 0);
    const auto negative =
        linear_verdict(slip_law_joint(1, 10, -1100, 1e-3, 1, 1.5, 1e-5)).state_variable;  // C = A/V_0 + k_v < 0
    CHECK(negative.stable_intervals.empty());
    CHECK(std::isnan(negative.k_cr));
    CHECK_FALSE(negative.stable);
}

TEST_CASE("a critical gain beyond all numbers is none", "[stability]")
{
    // B/L = 1e300 N/m and hardly any damping: k_cr is about 1e300 (B/A)(V_0/L) m
    const auto row = linear_point(slip_law_joint(1, 1e4, 0, 1e-3, 1e-20, 1e290, 1e-10));
    CHECK(row.reason == Reason::none);
    CHECK(row.region == Region::unstable);
    CHECK(std::isnan(row.k_cr));
}
