// Limit cycles by shooting against numbers that a continuation program and simulation found.
#include "analysis/simulation/attractor/cycle.h"

#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include "analysis/stability/verdict.h"

using namespace stickslip;

namespace {

/// From the growth of the unstable mode to a first guess on the section: spirals out until it reaches the orbit.
Cycle cycle_of(const Joint& joint, double rtol)
{
    const auto flow = sliding_flow(joint).flow;
    CycleOptions options;
    options.rtol = rtol;
    const double G = 4 * (std::pow(1 + flow.inertia, 2) + 2 * std::pow(flow.inertia, 2)) /
                     (flow.inertia * (1 + 9 * flow.inertia) * 1.5);
    FlowVector y = flow.steady();
    y[0] = std::sqrt(G * (1 - flow.k_p / (0.5 * (1 + flow.inertia)))) /
           std::sqrt(0.5);  // x = ln V amplitude / ω, ω² = β − 1
    y[2] = -flow.k_p * y[0];
    for (int i = 0; i < 10; ++i) {
        const auto turn = revolve(flow, y, options);
        REQUIRE(turn);
        y = turn->end;
    }
    const auto cycle = find_cycle(flow, y, options);
    REQUIRE(cycle);
    return *cycle;
}

}  // namespace

TEST_CASE("limit cycles at 0.9 k_cr: period and range of ln V", "[nonlinear]")
{
    // slip law, k_v = 0, β = 1.5; k_cr = (β − 1)(1 + M) in units of A/L. The ranges of ln V were read off the mesh of a
    // continuation program, good to about 1e-5.
    struct Known {
        double M, period, z_min, z_max;
    };
    for (const auto& known : {Known{10, 9.38322070, -0.364852, 0.269560}, Known{1, 9.54321087, -0.473805, 0.371977}}) {
        const auto cycle = cycle_of(dimensionless_joint(0.9 * 0.5 * (1 + known.M), known.M, 1.5, 0), 1e-11);
        CHECK(cycle.period == Approx(known.period).epsilon(1e-9));
        CHECK(std::log(cycle.velocity_min) == Approx(known.z_min).margin(2e-5));
        CHECK(std::log(cycle.velocity_max) == Approx(known.z_max).margin(2e-5));
        CHECK(cycle.attracts());
    }
}

TEST_CASE("the range of ln V against an explicit method of order 8", "[nonlinear]")
{
    // SciPy 1.10 DOP853 at rtol 1e-12 sampled at 4 million instants: M = 1, β = 1.5, 0.9 k_cr
    const auto cycle = cycle_of(dimensionless_joint(0.9, 1, 1.5, 0), 1e-11);
    CHECK(std::log(cycle.velocity_max) == Approx(0.3719888849).margin(3e-9));
    CHECK(std::log(cycle.velocity_min) == Approx(-0.4738078900).margin(3e-9));
}

TEST_CASE("Floquet multipliers: close to k_cr the orbit contracts at twice the rate at which steady sliding repels",
          "[nonlinear]")
{
    // supercritical Hopf normal form: ln μ = −2 σ T to first order in the distance
    const double below = 1e-3;
    const auto joint = dimensionless_joint((1 - below), 1, 1.5, 0);
    const auto cycle = cycle_of(joint, 1e-11);
    const auto linear = linear_point(joint);
    CHECK(std::log(cycle.multipliers[0].real()) == Approx(-2 * linear.spectral_abscissa * cycle.period).epsilon(0.01));
}
