// Contacts with a direct effect whose friction changes its sign within a speed that nothing resolves: against an
// integration whose every step solves the balance of forces by bisection, to which no core is too narrow.
#include <catch2/catch.hpp>
#include <cmath>

#include "analysis/boundary/kinds/outcome.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/flows/chain_flow.h"
#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/flows/mode.h"
#include "analysis/simulation/solvers/motion.h"

using namespace stickslip;

namespace {

/// A rotary joint; f0/A = 60 is usual for rock, for which the core is 10⁻²⁷ rad/s wide.
Joint rotary(double f0_per_A, MemoryForm evolution = MemoryForm::slip)
{
    RateAndStateRegularised law;
    law.A = 0.01, law.f0 = f0_per_A * law.A;
    law.B.push_back(1.5 * law.A);
    law.L.push_back(5e-4);
    law.V_star = 0.05;
    law.evolution = evolution;
    Joint joint;
    joint.mechanism.inertia = 0.05;
    joint.control.k_p = 600, joint.control.k_v = 0.5, joint.control.V0 = 0.05;
    joint.friction.law = law;
    return joint;
}

/// What an observer of one turn sees.
struct Seen {
    double end, farthest, slowest, state;
};

/// Implicit Euler: m (v − v_n)/h + k_p x + k_v (v − V_0) + A asinh(v/(2V*) e^{(f0 + θ)/A}) = f_ss, x = x_n + h (v −
/// V_0), θ exactly over the step at |v|. The left side rises with v, so bisection always finds v. From x_0 at V_0 to
/// where the speed, having been above V_0, falls below it.
Seen by_bisection(const Joint& joint, double x, double theta, double h)
{
    const auto& law = std::get<RateAndStateRegularised>(joint.friction.law);
    const auto& c = joint.control;
    const double A = law.A, B = law.B[0], L = law.L[0], steady = law.steady_force(c.V0);
    const auto friction = [&](double v, double state) {
        const double exponent = std::log(std::abs(v) / (2 * law.V_star)) + (law.f0 + state) / A;
        return std::copysign(A * (exponent > 30 ? exponent + std::log(2.0) : std::asinh(std::exp(exponent))), v);
    };
    const auto aged = [&](double speed) {
        const double slip = speed * h / L;
        if (law.evolution == MemoryForm::slip) {
            const double to = -B * std::log(speed / law.V_star);
            return speed > 0 ? to + (theta - to) * std::exp(-slip) : theta;
        }
        const double age = L / law.V_star * std::exp(theta / B), last = L / speed;
        return B * std::log((slip > 1e-9 ? last + (age - last) * std::exp(-slip) : age + h) * law.V_star / L);
    };
    double v = c.V0, t = 0;
    Seen seen{missing, x, v, theta};
    for (bool above = false; t < 10;) {
        const auto left = [&](double u) {
            return joint.mechanism.inertia * (u - v) / h + c.k_p * (x + h * (u - c.V0)) + c.k_v * (u - c.V0) +
                   friction(u, aged(std::abs(u))) - steady;
        };
        const double sign = left(0) > 0 ? -1 : 1;   // of the new speed
        double low = -700, high = std::log(100.0);  // of its logarithm
        for (int k = 0; k < 100; ++k) {
            const double middle = 0.5 * (low + high);
            (sign * left(sign * std::exp(middle)) > 0 ? high : low) = middle;
        }
        const double u = sign * std::exp(high);
        theta = aged(std::abs(u));
        x += h * (u - c.V0);
        t += h;
        if (above && u < c.V0) {
            seen.end = t - h * (c.V0 - u) / (v - u);
            seen.state = theta;
            return seen;
        }
        above |= u > c.V0;
        v = u;
        seen.farthest = std::max(seen.farthest, x);
        seen.slowest = std::min(seen.slowest, v);
    }
    return seen;
}

/// The limit of small steps, of an error of first order.
Seen by_bisection(const Joint& joint, double x, double theta)
{
    const Seen coarse = by_bisection(joint, x, theta, 4e-6), fine = by_bisection(joint, x, theta, 2e-6);
    const auto limit = [](double a, double b) { return 2 * b - a; };
    return {limit(coarse.end, fine.end), limit(coarse.farthest, fine.farthest), limit(coarse.slowest, fine.slowest),
            limit(coarse.state, fine.state)};
}

Turn followed(const Flow& flow, int bodies, double x, Solver solver, double rtol)
{
    FlowVector y = flow.steady();
    y.head(bodies).array() += x;
    SlidingMotion motion(flow, solver, rtol);
    motion.start(y);
    return motion.turn(10);
}

}  // namespace

TEST_CASE("a mass that turns round under a steep contact moves as in an integration by bisection", "[steep][slow]")
{
    const auto evolution = GENERATE(MemoryForm::slip, MemoryForm::ageing);
    const double f0_per_A = GENERATE(60.0, 25.0, 600.0);
    const double x = GENERATE(1.389e-3, 3e-3);  // the first is held at once, the second is pushed back
    CAPTURE(static_cast<int>(evolution), f0_per_A, x);
    const auto joint = rotary(f0_per_A, evolution);
    const Seen oracle = by_bisection(joint, x, 0);
    for (const auto solver : {Solver::cvode, Solver::rodas5p})
        for (const double rtol : {1e-6, 1e-8, 1e-9}) {
            CAPTURE(static_cast<int>(solver), rtol);
            const Turn turn = followed(sliding_flow(joint).flow, 1, x, solver, rtol);
            REQUIRE(turn.end == Turn::End::crossing);
            CHECK(turn.t1 == Approx(oracle.end).epsilon(1e-4));
            CHECK(turn.position_max == Approx(oracle.farthest).epsilon(1e-5));
            CHECK(turn.velocity_min == Approx(oracle.slowest).epsilon(5e-4).margin(1e-5 * 0.05));
            CHECK(turn.state[2] == Approx(oracle.state).epsilon(1e-3));
        }
}

TEST_CASE("of two masses on a stiff shaft the one under a steep contact turns round like one mass", "[steep]")
{
    Joint one = rotary(60), two = one;
    two.mechanism.model = Model::two_mass;
    two.mechanism.motor_inertia = 0.1 * one.mechanism.inertia, two.mechanism.link_inertia = 0.9 * one.mechanism.inertia;
    two.mechanism.transmission.stiffness = 1e6, two.mechanism.transmission.damping = 100;
    two.frictions.motor.law = CoulombViscous{0, 0};
    two.frictions.link.law = one.friction.law;
    const double x = 1.389e-3;
    const Seen oracle = by_bisection(one, x, 0);
    const Turn turn = followed(chain_flow(two).flow, 2, x, Solver::cvode, 1e-8);
    REQUIRE(turn.end == Turn::End::crossing);
    CHECK(turn.t1 == Approx(oracle.end).epsilon(2e-3));
    CHECK(turn.state[4] == Approx(oracle.state).epsilon(0.02));
}

TEST_CASE("where the core is resolved the contact is no event, and both ways to follow it agree", "[steep][slow]")
{
    const double f0_per_A = GENERATE(10.0, 18.0, 21.0);
    const auto joint = rotary(f0_per_A);
    const auto flow = sliding_flow(joint).flow;
    CHECK(flow.steep() == (f0_per_A > 20));
    const Seen oracle = by_bisection(joint, 1.389e-3, 0);
    const Turn turn = followed(flow, 1, 1.389e-3, Solver::cvode, 1e-8);
    REQUIRE(turn.end == Turn::End::crossing);
    CHECK(turn.t1 == Approx(oracle.end).epsilon(1e-4));
    CHECK(turn.velocity_min == Approx(oracle.slowest).epsilon(5e-4).margin(1e-5 * 0.05));
}

TEST_CASE("from rest a steep contact has the outcomes of the logarithmic law", "[steep]")
{
    // forwards the two laws are one; at this design the boundary is at 53.85 kN/m by either
    Joint joint;
    joint.mechanism.inertia = 1;
    joint.control.V0 = 1e-3;
    RateAndStateRegularised smooth;
    smooth.f0 = 60, smooth.A = 1, smooth.V_star = 1e-3;
    smooth.B.push_back(1.5), smooth.L.push_back(1e-5);
    RateAndState logarithmic;
    static_cast<RateStateParameters&>(logarithmic) = smooth;
    for (const double k_p : {600.0, 6e3, 45e3, 48e3, 60e3, 6e5})
        for (const double share : {0.0, 1e-4}) {
            CAPTURE(k_p, share);
            joint.control.k_p = k_p;
            joint.friction.law = smooth;
            const double side = outcome_side(joint, {DisturbanceKind::start, share});
            joint.friction.law = logarithmic;
            CHECK(side == outcome_side(joint, {DisturbanceKind::start, share}));
        }
}
