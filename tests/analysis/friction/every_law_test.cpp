// What every law must do, whichever it is, and what each declares of itself.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "analysis/stability/linear_friction.h"
#include "tests/analysis/friction/sample_laws.h"

using namespace stickslip;

namespace {

constexpr unsigned seed = 20260417;

/// Velocities at which a law is defined, both signs where it allows them, away from the kinks at V = 0.
std::vector<double> velocities(const FrictionLaw& law)
{
    std::vector<double> list;
    for (double V = 1e-5; V < 0.2; V *= 7) {
        list.push_back(V);
        if (!info(law).needs_motion) list.push_back(-V);
    }
    return list;
}

/// A state near the steady one at a neighbouring velocity: transient, but one that sliding could produce.
States transient(const FrictionLaw& law, double V, std::mt19937_64& random)
{
    States theta = steady_state(law, V * std::uniform_real_distribution<>(0.5, 2)(random));
    for (int i = 0; i < states(law); ++i) theta[i] *= std::uniform_real_distribution<>(0.3, 0.95)(random);
    return theta;
}

/// Central difference of fourth order.
template <class Function>
double difference(Function&& f, double at, double h)
{
    return (8 * (f(at + h) - f(at - h)) - (f(at + 2 * h) - f(at - 2 * h))) / (12 * h);
}

}  // namespace

TEST_CASE("every law of the list has a sample, a name of its own, a formula, a source and a range", "[friction]")
{
    const auto samples = samples::laws();
    for (const auto& law : laws()) {
        INFO(law.name);
        CHECK(std::any_of(samples.begin(), samples.end(), [&](const auto& s) { return info(s.law).name == law.name; }));
        CHECK_FALSE(law.formula.empty());
        CHECK_FALSE(law.source.empty());
        CHECK_FALSE(law.validity.empty());
        const auto named = law_named(law.name);
        REQUIRE(named);
        CHECK(info(*named).name == law.name);
    }
    CHECK_FALSE(law_named("no such law"));
}

TEST_CASE("derivatives of every law agree with differences", "[friction]")
{
    std::mt19937_64 random(seed);
    INFO("seed " << seed);
    for (const auto& [name, sample] : samples::laws()) {
        const auto& law = sample;  // Clang 14 captures no structured binding
        for (const double V : velocities(law)) {
            const States theta = transient(law, V, random);
            const auto r = respond(law, V, theta);
            CAPTURE(name, V);
            const double h = 1e-4 * std::abs(V);
            if (!info(law).needs_history) {
                const auto force = [&](double v) { return respond(law, v, theta).force; };
                const double noise = 1e-12 * std::abs(r.force) / h;
                CHECK(difference(force, V, h) == Approx(r.by_velocity).epsilon(1e-7).margin(noise));
            }
            for (int i = 0; i < states(law); ++i) {
                const auto rate = [&](double v) { return respond(law, v, theta).rate[i]; };
                const double noise = 1e-12 * std::abs(r.rate[i]) / h;
                CHECK(difference(rate, V, h) == Approx(r.rate_by_velocity[i]).epsilon(1e-7).margin(noise));
                const double step = 1e-5 * std::max(std::abs(theta[i]), 1e-12);
                const auto at = [&](double x) {
                    States moved = theta;
                    moved[i] = x;
                    return respond(law, V, moved);
                };
                CHECK(difference([&](double x) { return at(x).force; }, theta[i], step) ==
                      Approx(r.by_state[i]).epsilon(1e-6).margin(1e-12 * std::abs(r.force) / step));
                CHECK(difference([&](double x) { return at(x).rate[i]; }, theta[i], step) ==
                      Approx(r.rate_by_state[i]).epsilon(1e-6).margin(1e-12 * std::abs(r.rate[i]) / step));
            }
        }
    }
}

TEST_CASE("steady sliding is a fixed point of every law and carries its steady force", "[friction]")
{
    for (const auto& [name, law] : samples::laws())
        for (const double V : velocities(law)) {
            CAPTURE(name, V);
            const States theta = steady_state(law, V);
            const auto r = respond(law, V, theta);
            CHECK(r.force == Approx(steady_force(law, V)).epsilon(1e-13));
            for (int i = 0; i < states(law); ++i) {
                // against the rate of a state that is one part in a thousand off
                States off = theta;
                off[i] = 1.001 * theta[i] + 1e-12;
                const auto moved = respond(law, V, off);
                CHECK(std::abs(r.rate[i]) <= 1e-10 * std::abs(moved.rate[i]) + 1e-13 * std::abs(V * theta[i]));
            }
        }
}

TEST_CASE("states return to steady sliding", "[friction]")
{
    for (const auto& [name, law] : samples::laws())
        for (const double V : velocities(law)) {
            CAPTURE(name, V);
            const auto r = respond(law, V, steady_state(law, V));
            for (int i = 0; i < states(law); ++i) CHECK(r.rate_by_state[i] <= 0);
        }
}

TEST_CASE("the slope of the steady curve is the direct effect less the integral of the kernel", "[friction]")
{
    // (15) closes the circle: the left side knows nothing of states, delays or tables
    for (const auto& [name, law] : samples::laws())
        for (const double V : velocities(law)) {
            CAPTURE(name, V);
            Friction friction;
            friction.law = law;
            const double h = 1e-4 * std::abs(V);
            const auto curve = [&l = law](double v) { return steady_force(l, v); };
            const double noise = 1e-12 * std::abs(curve(V)) / h;
            CHECK(steady_slope(linearise(friction, V)) == Approx(difference(curve, V, h)).epsilon(1e-6).margin(noise));
        }
}

TEST_CASE("each law has the properties of the paper that it declares", "[friction]")
{
    for (const auto& [name, law] : samples::laws()) {
        CAPTURE(name);
        const auto& declared = info(law);
        // (1) a steady-state curve that is not flat
        CHECK(declared.steady_state_dependence == (steady_force(law, 1e-3) != steady_force(law, 7e-3)));
        // (2) a step of velocity changes the force at once and in the same direction
        if (declared.direct_effect)
            for (const double V : velocities(law)) {
                const States theta = steady_state(law, V);
                const double jump = respond(law, 1.1 * V, theta).force - respond(law, V, theta).force;
                CHECK(jump * V > 0);
            }
        // (3) one slip distance over which states decay, whatever the velocity: three decades of V, one decade would
        // show
        //     a memory in time
        if (declared.slip_distance && name != "dahl, exponent 1.5") {
            for (int i = 0; i < states(law); ++i) {
                const double slow = 1e-5, fast = 1e-2;
                const double slow_distance = slow / -respond(law, slow, steady_state(law, slow)).rate_by_state[i];
                const double fast_distance = fast / -respond(law, fast, steady_state(law, fast)).rate_by_state[i];
                CHECK(slow_distance / fast_distance == Approx(1).epsilon(0.6));
            }
        }
    }
}

TEST_CASE("friction takes energy out of sliding, and is odd where it says so", "[friction]")
{
    std::mt19937_64 random(seed);
    INFO("seed " << seed);
    for (const auto& [name, law] : samples::laws())
        for (const double V : velocities(law)) {
            CAPTURE(name, V);
            if (!info(law).linear_only) CHECK(steady_force(law, V) * V >= 0);
            if (info(law).odd) CHECK(steady_force(law, -V) == Approx(-steady_force(law, V)).epsilon(1e-15));
            if (info(law).dissipative) {
                States theta{};
                for (int i = 0; i < states(law); ++i) theta[i] = std::uniform_real_distribution<>(-100, 100)(random);
                CHECK(respond(law, V, theta).force * V >= 0);
            }
        }
}

TEST_CASE("at rest a law that is set-valued says how much it can hold, any other is a function", "[friction]")
{
    for (const auto& [name, law] : samples::laws()) {
        CAPTURE(name);
        if (info(law).set_valued_at_rest) {
            CHECK(static_force(law) >= 0);
            CHECK(respond(law, 0, {}).force == 0);
        } else if (!info(law).needs_motion) {
            const States theta = steady_state(law, 1e-3);
            const double forward = respond(law, 1e-300, theta).force, reverse = respond(law, -1e-300, theta).force;
            CHECK(forward == Approx(reverse).margin(1e-9));
            CHECK(std::isfinite(respond(law, 0, theta).force));
        }
    }
}
