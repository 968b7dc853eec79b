// Criticality of the Hopf point and folds of limit cycles against closed forms and published folds.
#include "analysis/simulation/attractor/bifurcation.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

namespace {

double critical_gain_of(double M, double beta, double c)
{
    return (beta - 1 - c) * (1 + M / (1 + c));
}

HopfPoint hopf_of(double M, double beta, double c)
{
    return hopf_point(sliding_flow(dimensionless_joint(critical_gain_of(M, beta, c), M, beta, c)).flow);
}

/// β = 1.5 with contacts that age.
Joint ageing_joint(double K, double M)
{
    Joint joint = dimensionless_joint(K, M, 1.5, 0);
    Ageing law;
    static_cast<RateStateParameters&>(law) = std::get<RateAndState>(joint.friction.law);
    joint.friction.law = law;
    return joint;
}

}  // namespace

TEST_CASE("first Lyapunov coefficient against the amplitude law", "[nonlinear]")
{
    // r² = G (1 − k_p/k_cr) at σ r + l r³ = 0, so l = −σ'/G with σ' = dσ/d(1 − k_p/k_cr);
    // G = 4[(1+M)² + 4M²(β−1)]/[M(1+9M)β], slip law with k_v = 0
    for (const auto& [M, beta] : {std::pair{1.0, 1.5}, {1.0, 4.0}, {10.0, 1.5}, {0.01, 2.0}}) {
        const auto hopf = hopf_of(M, beta, 0);
        const double G = 4 * ((1 + M) * (1 + M) + 4 * M * M * (beta - 1)) / (M * (1 + 9 * M) * beta);
        // σ' from the cubic M s³ + (M+1) s² + (1+K−β) s + K at s = iω, dK = −K_cr
        const std::complex<double> s(0, hopf.omega);
        const double K = critical_gain_of(M, beta, 0);
        const auto slope = K * (s + 1.0) / (3 * M * s * s + 2 * (M + 1) * s + (1 + K - beta));
        CAPTURE(M, beta);
        CHECK(hopf.omega == Approx(std::sqrt(beta - 1)).epsilon(1e-9));
        CHECK(hopf.lyapunov == Approx(-slope.real() / G).epsilon(1e-5));
    }
}

TEST_CASE("the Hopf point is subcritical for k_v V_0 near B − A and large M", "[nonlinear]")
{
    CHECK(hopf_of(10, 1.5, 0.94 * 0.5).lyapunov > 0);
    CHECK(hopf_of(10, 1.5, 0.2).lyapunov < 0);
    CHECK(hopf_of(0.1, 1.5, 0.2).lyapunov < 0);
}

TEST_CASE("ageing law: subcritical for M < 1/(3 + 2√(β+3))", "[nonlinear]")
{
    const double border = 1 / (3 + 2 * std::sqrt(1.5 + 3));
    for (const double M : {border * 0.999, border * 1.001}) {
        const auto flow = sliding_flow(ageing_joint(critical_gain_of(M, 1.5, 0), M)).flow;
        CHECK((hopf_point(flow).lyapunov > 0) == (M < border));
    }
}

TEST_CASE("folds of limit cycles", "[nonlinear][slow]")
{
    const CycleOptions options;
    SECTION("A = 1, B = 1.5, L = 1e-5, m = 1, V_0 = 1e-2, k_v = 47.5: 24849 N/m above k_cr = 19449")
    {
        const double k_cr = 0.025 / 1e-5 * (1 + 1e-4 / (1e-5 * (1 + 0.475)));
        CHECK(k_cr == Approx(19449).margin(1));
        const auto flow = sliding_flow(example_joint(k_cr, 47.5, 1e-2)).flow;
        const auto fold = fold_of_cycles(flow, hopf_point(flow), options);
        REQUIRE(fold);
        CHECK(fold->k_p == Approx(24849).margin(1));
    }
    SECTION("beta = 1.5, M = 10, k_v V_0/(B − A) = 0.94: at 1.166 k_cr")
    {
        const double k_cr = critical_gain_of(10, 1.5, 0.47);
        const auto flow = sliding_flow(dimensionless_joint(k_cr, 10, 1.5, 0.47)).flow;
        const auto fold = fold_of_cycles(flow, hopf_point(flow), options);
        REQUIRE(fold);
        CHECK(fold->k_p / k_cr == Approx(1.166).margin(5e-4));
    }
    SECTION("ageing law, M = 10^-1.5: at 1.00584 k_cr")
    {
        const double M = std::pow(10, -1.5), k_cr = critical_gain_of(M, 1.5, 0);
        const auto flow = sliding_flow(ageing_joint(k_cr, M)).flow;
        const auto fold = fold_of_cycles(flow, hopf_point(flow), options);
        REQUIRE(fold);
        CHECK(fold->k_p / k_cr == Approx(1.00584).margin(5e-6));
    }
    SECTION("slip law with k_v = 0: supercritical, no fold")
    {
        const auto flow = sliding_flow(dimensionless_joint(critical_gain_of(1, 1.5, 0), 1, 1.5, 0)).flow;
        CHECK_FALSE(fold_of_cycles(flow, hopf_point(flow), options));
    }
}
