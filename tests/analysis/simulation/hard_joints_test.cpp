// Joints at which an integration once stood still, ran for ever, or lost its time in rounding.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/simulation/flows/break_away.h"
#include "analysis/simulation/points.h"
#include "analysis/simulation/simulate.h"
#include "analysis/stability/verdict.h"

using namespace stickslip;

namespace {

Joint joint_with(decltype(Friction::law) law, double inertia, double k_p, double k_v, double V0)
{
    Joint joint;
    joint.mechanism.inertia = inertia;
    joint.control.k_p = k_p;
    joint.control.k_v = k_v;
    joint.control.V0 = V0;
    joint.friction.law = std::move(law);
    return joint;
}

Stribeck stribeck(double c0, double c1, double c2, double c3, double c4)
{
    Stribeck law;
    law.c0 = c0;
    law.c1 = c1;
    law.c2 = c2;
    law.c3 = c3;
    law.c4 = c4;
    return law;
}

RateAndState rate_and_state(double f0, double A, double B, double L)
{
    RateAndState law;
    law.f0 = f0;
    law.A = A;
    law.B.push_back(B);
    law.L.push_back(L);
    law.V_star = 1e-3;
    return law;
}

}  // namespace

TEST_CASE("a mass that the spring just overcomes breaks away once, not for ever")
{
    const auto joint =
        joint_with(stribeck(9.733562606182968, 5.354450832637536, 0.4674204531001499, 0.0002421339927799778, 2),
                   0.023775181892194963, 199.5178034972012, 0, 0.008330926736576903);
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.region == NonlinearRegion::stable);
    CHECK(verdict.growth_rate == Approx(linear_verdict(joint).state_variable.spectral_abscissa).epsilon(1e-4));
}

TEST_CASE("friction with a vertical tangent at rest throws the mass off as in closed form")
{
    // m dV/dt = c2 (V/c3)^(1/2), from rest at the static friction, for V << c3: V = (c2 t / (2 m))² / c3
    const double m = 2, c2 = 0.5, c3 = 0.04, V = 1e-9;
    auto joint = joint_with(stribeck(3, 0, c2, c3, 0.5), m, 1, 0, 1e-3);
    auto flow = sliding_flow(joint).flow;
    FlowVector y = flow.steady();
    y[0] = (flow.steady_friction - flow.static_force()) / flow.k_p;
    y[1] = 0;
    const auto launch = break_away(flow, y, V);
    REQUIRE(launch);
    const double time = 2 * m * std::sqrt(V * c3) / c2;
    CHECK(launch->time == Approx(time).epsilon(5e-3));  // the spring winds on and the drop bends, both less than that
    CHECK(launch->x - y[0] == Approx(-1e-3 * launch->time).epsilon(1e-3));
    SECTION("other exponents leave rest without help")
    {
        for (double exponent : {1.0, 2.0}) {
            joint.friction.law = stribeck(3, 0, c2, c3, exponent);
            CHECK_FALSE(break_away(sliding_flow(joint).flow, y, V));
        }
    }
    SECTION("and the whole joint has an outcome")
    {
        joint.control.k_p = 1e4;
        const auto verdict = nonlinear_verdict(joint, {});
        CHECK(verdict.outcome == Outcome::stick_slip);
        CHECK(verdict.stick_fraction > 0);
    }
}

TEST_CASE("slips of microseconds after minutes of creep are the same to both solvers", "[slow]")
{
    const auto joint =
        joint_with(rate_and_state(97.69110405902684, 1.6281850676504475, 3.5482282373731686, 1.027797486846732e-05),
                   0.051423389240240126, 7840.640658823294, 0.2277114291823279, 1.059838447199099e-05);
    NonlinearOptions options;
    options.bifurcation = false;
    const auto cvode = nonlinear_verdict(joint, options);
    options.fallback_only = true;
    const auto rodas = nonlinear_verdict(joint, options);
    CHECK(cvode.outcome == Outcome::stick_slip);
    CHECK(std::isfinite(cvode.velocity_max));
    CHECK(cvode.period == Approx(rodas.period).epsilon(1e-5));
    CHECK(cvode.amplitude == Approx(rodas.amplitude).epsilon(1e-5));
    CHECK(cvode.velocity_max == Approx(rodas.velocity_max).epsilon(1e-3));
}

TEST_CASE("springs of the friction that are saturated in steady sliding take no part in its modes")
{
    MaxwellSlip law;
    law.elements.push_back({6e4, 0.18});
    law.elements.push_back({5.6e5, 0.89});
    law.viscous = 5.5;
    const auto joint = joint_with(law, 2.6, 4.3e5, 0, 4.7e-5);
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.region == NonlinearRegion::stable);
    CHECK(verdict.growth_rate == Approx(-5.5 / (2 * 2.6)).epsilon(1e-2));
}

TEST_CASE("a kernel has no nonlinear outcome")
{
    Kernel law;
    law.f_v = 20;
    law.exponentials.push_back({1e3, 100});
    law.V_star = 1e-3;
    const auto verdict = nonlinear_verdict(joint_with(law, 1, 1e4, 10, 1e-3), {});
    CHECK(verdict.outcome == Outcome::linear_only);
    CHECK(verdict.reason == Reason::linear_only);
}

TEST_CASE("growth is measured where rounding lets a solver creep at a finer tolerance")
{
    const auto joint = joint_with(rate_and_state(60, 0.1237701123, 0.1448433585, 4.634646975e-06), 1.55982048,
                                  4.232140108, 5743.038941, 3.667052404e-06);
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.outcome == Outcome::stable_sliding);
    CHECK(verdict.growth_rate == Approx(linear_verdict(joint).state_variable.spectral_abscissa).epsilon(1e-4));
}

TEST_CASE("lanes find the lowest speed of a stiff cycle as finely as CVODE that only watches it")
{
    const auto joint = joint_with(rate_and_state(60, 3.615296637, 6.714747865, 2.004262516e-05), 0.1057623384,
                                  2718.442951, 1100699.361, 2.492410601e-06);
    std::vector<PointResult> rows{linear_point(joint)};
    nonlinear_points({&joint, 1}, {}, rows);
    NonlinearOptions watch;
    watch.rtol = 1e-11;
    watch.accelerate = watch.region = false;
    const auto truth = nonlinear_verdict(joint, watch);
    CHECK(rows[0].path == DecisionPath::lanes);
    CHECK(rows[0].velocity_min == Approx(truth.velocity_min).epsilon(1e-5));
    CHECK(rows[0].velocity_max == Approx(truth.velocity_max).epsilon(1e-5));
}

TEST_CASE("turns that take no time are no cycle")
{
    const auto joint = joint_with(stribeck(15, 5, 300, 100, 1), 1, 2e4, 10, 1e-150);
    const auto verdict = nonlinear_verdict(joint, {});
    CHECK(verdict.region == NonlinearRegion::undecided);
    CHECK(verdict.reason == Reason::not_converged);
    CHECK(std::isnan(verdict.period));
}

TEST_CASE("bristles let a mass go from a speed that stands on the section to the last bit", "[slow]")
{
    // the other integrator is the oracle: each of these stood still under CVODE at its first crossing
    LuGre law;
    law.sigma0 = 1e6, law.sigma1 = 1e3, law.sigma2 = 50;
    law.coulomb = 15, law.breakaway = 20, law.stribeck_velocity = 2e-3;
    for (const double decades : {3.3, 3.45, 4.125, 5.175}) {
        const auto joint = joint_with(law, 1, std::pow(10, decades), 10, 1e-3);
        NonlinearOptions options, other;
        options.region = other.region = false;
        other.fallback_only = true;
        const auto verdict = nonlinear_verdict(joint, options), expected = nonlinear_verdict(joint, other);
        CAPTURE(decades);
        CHECK(verdict.reason == Reason::none);
        CHECK(verdict.outcome == (decades < 5 ? Outcome::reversal : Outcome::period_n));
        CHECK(verdict.outcome == expected.outcome);
        CHECK(verdict.period == Approx(expected.period).epsilon(1e-5));
    }
}

TEST_CASE("a motion is followed through turns of the cycle that it ends in, however long they are")
{
    LuGre law;
    law.sigma0 = 1e6, law.sigma1 = 1e3, law.sigma2 = 50;
    law.coulomb = 15, law.breakaway = 20, law.stribeck_velocity = 2e-3;
    const auto joint = joint_with(law, 1, 2818, 10, 1e-3);
    SimulateOptions options;
    options.cycle_period = nonlinear_verdict(joint, {}).period;
    const auto path = simulate(joint, options);
    REQUIRE(path.reason == Reason::none);
    // counted in the motion itself: slips of the last third, each beginning where the speed rises through ten V_0
    int slips = 0;
    for (std::size_t i = 1; i < path.time.size(); ++i)
        if (path.time[i] > 2 * path.time.back() / 3 && path.velocity[i - 1] < 0.01 && path.velocity[i] >= 0.01) ++slips;
    CHECK(slips >= 2);
}
