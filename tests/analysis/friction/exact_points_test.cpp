// Points of each law that a hand can check.
#include <catch2/catch.hpp>

#include "analysis/friction/friction.h"
#include "tests/analysis/friction/sample_laws.h"

using namespace stickslip;

namespace {

/// One state at constant velocity, by the classical Runge-Kutta method.
double evolved(const FrictionLaw& law, double V, double theta, double time, int steps)
{
    const auto rate = [&](double x) { return respond(law, V, States{x}).rate[0]; };
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const double k1 = rate(theta), k2 = rate(theta + h / 2 * k1), k3 = rate(theta + h / 2 * k2),
                     k4 = rate(theta + h * k3);
        theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return theta;
}

}  // namespace

TEST_CASE("static laws: levels in motion and at rest", "[friction]")
{
    const CoulombViscous simple{10, 5};
    CHECK(simple.steady_force(2) == 20);
    CHECK(simple.steady_force(-2) == -20);
    CHECK(static_force(FrictionLaw(simple)) == 10);
    const KineticStatic two_level{10, 13};
    CHECK(two_level.steady_force(1e-9) == 10);
    CHECK(static_force(FrictionLaw(two_level)) == 13);
    CHECK(two_level.respond(0.3, {}).by_velocity == 0);
    const Stribeck curve{10, 5, 4, 1e-2, 2};
    CHECK(curve.steady_force(1e-2) == Approx(10 + 0.05 + 4 * std::exp(-1)).epsilon(1e-15));
    CHECK(curve.steady_force(1) == Approx(15).epsilon(1e-15));
    CHECK(static_force(FrictionLaw(curve)) == 14);
}

TEST_CASE("rate-and-state: a velocity step e-fold, by hand", "[friction]")
{
    // V jumps from V* to e V*: f rises by A at once, then falls by B over a few L to f0 + A − B
    const auto law = samples::rate_and_state<RateAndState>();
    const double V = std::exp(1) * 1e-3;
    CHECK(law.respond(V, {0}).force == Approx(61).epsilon(1e-14));
    CHECK(law.steady_force(V) == Approx(59.5).epsilon(1e-14));
    // slip law: the distance to steady state decays exactly as e^{−slip/L}
    const double after = evolved(law, V, 0, 1e-5 / V, 400);
    CHECK(after == Approx(-1.5 * (1 - std::exp(-1))).epsilon(1e-9));
}

TEST_CASE("ageing: contacts grow with the logarithm of time at rest, slip law contacts do not", "[friction]")
{
    const auto law = samples::rate_and_state<Ageing>();
    // φ = φ_0 + t at V = 0: θ = B ln(V* φ/L); from θ = 0 (φ_0 = L/V* = 10 ms) to 0.63 s
    const double held = evolved(law, 1e-30, 0, 0.63, 20000);
    CHECK(held == Approx(1.5 * std::log(64)).epsilon(1e-9));
    CHECK(samples::rate_and_state<RateAndState>().respond(1e-30, {0}).rate[0] == Approx(0).margin(1e-20));
    // age at constant V: φ = L/V + (φ_0 − L/V) e^{−Vt/L}
    const double V = 5e-3, age = 1e-5 / V + (1e-2 - 1e-5 / V) * std::exp(-2);
    CHECK(evolved(law, V, 0, 2e-5 / V, 4000) == Approx(1.5 * std::log(1e-3 * age / 1e-5)).epsilon(1e-9));
}

TEST_CASE("the regularised law is the logarithmic law away from rest and passes through zero", "[friction]")
{
    for (const auto evolution : {MemoryForm::slip, MemoryForm::ageing}) {
        const auto smooth = samples::regularised(evolution);
        for (const double V : {1e-6, 1e-3, 0.1}) {
            const States theta{0.4};
            const auto reference = evolution == MemoryForm::slip
                                       ? samples::rate_and_state<RateAndState>().respond(V, theta)
                                       : samples::rate_and_state<Ageing>().respond(V, theta);
            const auto r = smooth.respond(V, theta), reverse = smooth.respond(-V, theta);
            CHECK(r.force == Approx(reference.force).epsilon(1e-14));
            CHECK(r.by_velocity == Approx(reference.by_velocity).epsilon(1e-14));
            CHECK(r.rate[0] == Approx(reference.rate[0]).epsilon(1e-14));
            CHECK(r.rate_by_velocity[0] == Approx(reference.rate_by_velocity[0]).epsilon(1e-14));
            CHECK(reverse.force == -r.force);
            CHECK(reverse.rate[0] == r.rate[0]);
        }
        CHECK(smooth.respond(0, {0.4}).force == 0);
    }
    // a soft contact by hand: A = 1, level 2, V = 2 V*: asinh(e²)
    const auto soft = regularised_force(1, 1e-3, 2, 2e-3);
    CHECK(soft.force == Approx(std::asinh(std::exp(2))).epsilon(1e-15));
    // near zero it is the tangent A e^{ψ/A}/(2V*) V
    CHECK(regularised_force(1, 1e-3, 2, 1e-9).force == Approx(regularised_force(1, 1e-3, 2, 0).by_velocity * 1e-9));
}

TEST_CASE("dahl: stiffness at reversal and the exponential approach", "[friction]")
{
    const Dahl law{10, 1e5, 1};
    CHECK(law.respond(1e-3, {0}).rate[0] == 1e-3);
    // after the slip of F_c/σ0 from z = 0: f = F_c (1 − 1/e)
    const double z = evolved(law, 1e-3, 0, 1e-4 / 1e-3, 500);
    CHECK(law.respond(1e-3, {z}).force == Approx(10 * (1 - std::exp(-1))).epsilon(1e-10));
    // right after a reversal from −F_c the bristle moves twice as fast as the mass
    CHECK(law.respond(1e-3, {-1e-4}).rate[0] == Approx(2e-3));
}

TEST_CASE("lugre: direct effect and steady slope of the stiff bristle", "[friction]")
{
    // V_0 = v_s/√2: f_v = σ1 V g'/g + σ2 = −73.185, f_ss' = −428.482 N·s/m
    const FrictionLaw law = samples::lugre();
    const double V = 1e-3 / std::sqrt(2.0);
    CHECK(respond(law, V, steady_state(law, V)).by_velocity == Approx(-73.185).epsilon(1e-5));
    CHECK(steady_slope(law, V) == Approx(-428.482).epsilon(1e-6));
    CHECK(steady_force(law, V) == Approx(1 + 0.5 * std::exp(-0.5) + 0.4 * V).epsilon(1e-15));
}

TEST_CASE("maxwell slip: elements yield one after the other", "[friction]")
{
    const auto law = samples::maxwell_slip(false);  // k = 2e5, 5e4 N/m; W = 1, 2 N; viscous 3
    const auto stuck = law.respond(1e-3, {0, 0}), half = law.respond(1e-3, {1, 0.25}), all = law.respond(1e-3, {1, 2});
    CHECK(stuck.rate[0] == Approx(200));
    CHECK(stuck.rate[1] == Approx(50));
    CHECK(half.rate[0] == 0);
    CHECK(half.rate[1] == Approx(50));
    CHECK(all.rate[1] == 0);
    CHECK(all.force == Approx(3.003));
    // at reversal every element sticks again
    CHECK(law.respond(-1e-3, {1, 2}).rate[0] == Approx(-200));
    // generalised: slip level at rest 1.4 times the yield forces
    const auto general = samples::maxwell_slip(true);
    CHECK(general.steady_force(1e-9) == Approx(3 * 1.4).epsilon(1e-7));
    CHECK(general.steady_force(1) == Approx(3 + 3).epsilon(1e-12));
}

TEST_CASE("time lag: the curve, late", "[friction]")
{
    const auto law = samples::time_lag(Stribeck{10, 5, 4, 1e-2, 2}, 5e-3);
    CHECK(law.steady_force(2e-3) == Stribeck{10, 5, 4, 1e-2, 2}.steady_force(2e-3));
    const auto delays = law.delays(2e-3);
    REQUIRE(delays.size == 1);
    CHECK(delays[0].time == 5e-3);
    CHECK(delays[0].weight == Approx(-5 + 2 * 4 * 2e-3 / 1e-4 * std::exp(-0.04)).epsilon(1e-14));
}

TEST_CASE("kernel table: the transform of straight lines", "[friction]")
{
    KernelTable triangle;  // rises to 1 at t = 1, falls to 0 at t = 3
    triangle.time = {0, 1, 3};
    triangle.value = {0, 1, 0};
    CHECK(triangle.problem().empty());
    CHECK(triangle.at(0.25) == 0.25);
    CHECK(triangle.at(2) == 0.5);
    CHECK(triangle.at(4) == 0);
    // twice integrated by parts: G = (1/s²)(1 − 1.5 e^{−s} + 0.5 e^{−3s})
    const auto exact = [](std::complex<double> s) {
        return (1.0 - 1.5 * std::exp(-s) + 0.5 * std::exp(-3.0 * s)) / (s * s);
    };
    for (const std::complex<double> s : {std::complex<double>(0, 2), {0.3, 5}, {-0.2, 1}, {2, 0}, {0, 40}}) {
        CHECK(std::abs(triangle.transform(s) - exact(s)) < 1e-13);
        const double h = 1e-4;
        const auto slope = (exact(s + h) - exact(s - h)) / (2 * h);
        CHECK(std::abs(triangle.transform_slope(s) - slope) < 1e-7);
    }
    CHECK(triangle.transform(0).real() == Approx(1.5).epsilon(1e-15));
    CHECK(std::abs(triangle.transform({0, 1e-3}) - triangle.transform(0)) < 2e-3);
    CHECK(triangle.moment(0) >= 1.5);
    CHECK(triangle.variation() == 2);
}

TEST_CASE("bristles under a static law are LuGre", "[friction]")
{
    Friction friction;
    friction.law = Stribeck{1, 0.4, 0.5, 1e-3, 2};
    friction.bristle = {1e5, std::sqrt(1e5)};
    const FrictionLaw reference = samples::lugre();
    REQUIRE(states(friction) == 1);
    for (const double V : {-2e-3, 3e-4, 5e-2})
        for (const double z : {-1e-5, 0.0, 2e-6}) {
            const auto r = respond(friction, V, {z}), l = respond(reference, V, {z});
            CHECK(r.force == Approx(l.force).epsilon(1e-14));
            CHECK(r.by_velocity == Approx(l.by_velocity).epsilon(1e-13));
            CHECK(r.rate[0] == Approx(l.rate[0]).epsilon(1e-14).margin(1e-18));
        }
    CHECK(steady_state(friction, 3e-4)[0] == Approx(steady_state(reference, 3e-4)[0]).epsilon(1e-14));
}

TEST_CASE("memory on top of Coulomb friction is the regularised law", "[friction]")
{
    Friction friction;
    friction.law = CoulombViscous{60, 0};
    friction.memory.A = 1;
    friction.memory.B = 1.5;
    const FrictionLaw reference = samples::regularised(MemoryForm::slip);
    for (const double V : {-2e-3, 3e-4, 5e-2}) {
        const auto r = respond(friction, V, {0.7}), l = respond(reference, V, {0.7});
        CHECK(r.force == Approx(l.force).epsilon(1e-14));
        CHECK(r.by_velocity == Approx(l.by_velocity).epsilon(1e-14));
        CHECK(r.by_state[0] == l.by_state[0]);
        CHECK(r.rate[0] == Approx(l.rate[0]).epsilon(1e-14));
        CHECK(steady_force(friction, V) == Approx(steady_force(reference, V)).epsilon(1e-14));
    }
}

TEST_CASE("a level that follows the speed late", "[friction]")
{
    Friction friction;
    friction.law = Stribeck{10, 5, 4, 1e-2, 2};
    friction.memory.lag = 0.02;
    REQUIRE(states(friction) == 1);
    CHECK(steady_state(friction, -4e-3)[0] == 4e-3);
    CHECK(steady_force(friction, -4e-3) == Stribeck{10, 5, 4, 1e-2, 2}.steady_force(-4e-3));
    // at V = 8 mm/s with the level still that of 4 mm/s
    const auto r = respond(friction, 8e-3, {4e-3});
    CHECK(r.force == Approx(10 + 4 * std::exp(-0.16) + 5 * 8e-3).epsilon(1e-14));
    CHECK(r.rate[0] == Approx(4e-3 / 0.02));
    CHECK(r.by_velocity == Approx(5));
    // and the force of the whole curve, its viscous part included
    friction.memory.lag_viscous = true;
    const auto whole = respond(friction, -8e-3, {12});
    CHECK(whole.force == -12);
    CHECK(whole.by_velocity == 0);
    CHECK(whole.by_state[0] == -1);
    const double curve = 10 + 4 * std::exp(-0.64) + 5 * 8e-3;
    CHECK(whole.rate[0] == Approx((curve - 12) / 0.02).epsilon(1e-14));
    CHECK(whole.rate_by_velocity[0] == Approx(-(5 - 4 * std::exp(-0.64) * 2 * 8e-3 / 1e-4) / 0.02).epsilon(1e-14));
    CHECK(steady_state(friction, -8e-3)[0] == Approx(curve).epsilon(1e-14));
}

TEST_CASE("a direction dependence shifts the level and the slope of one direction", "[friction]")
{
    Friction friction;
    friction.law = CoulombViscous{10, 5};
    friction.asymmetry = {1, 2};
    CHECK(steady_force(friction, 3) == 10 + 1 + (5 + 2) * 3);
    CHECK(steady_force(friction, -3) == -(10 - 1 + (5 - 2) * 3));
    CHECK(respond(friction, -3, {}).by_velocity == 3);
    friction.asymmetry = {1, -2};
    CHECK(steady_force(friction, 3) == 10 + 1 + (5 - 2) * 3);
    CHECK(respond(friction, 3, {}).by_velocity == 3);
    CHECK(respond(friction, -3, {}).by_velocity == 7);
}
