// Which motions coexist, when turns count as repeats, and what is said where there is nothing to say.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "analysis/simulation/nonlinear.h"
#include "analysis/simulation/repeats.h"
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

TEST_CASE("LuGre: the motion that a pull of the spring reaches is found beside steady sliding", "[nonlinear]")
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

TEST_CASE("what keeps a joint from having an outcome is said in words", "[nonlinear]")
{
    const auto says = [](const Joint& joint, const std::string& word) {
        const auto verdict = nonlinear_verdict(joint, {});
        CHECK(verdict.outcome == Outcome::undecided);
        CHECK(verdict.region != NonlinearRegion::bistable);
        return std::string(verdict.explanation).find(word) != std::string::npos;
    };
    CHECK(says(example_joint(-10, 0, 1e-3), "diverges"));
    CHECK(says(example_joint(0, 0, 1e-3), "diverges"));
    CHECK(says(example_joint(1e4, -1001, 1e-3), "diverges"));
    Joint undamped = stribeck_joint(1e4, 0, 1e-3);
    undamped.friction.law = KineticStatic{8, 14};
    CHECK(says(undamped, "neutral"));
    Dahl dahl;
    dahl.coulomb = 10, dahl.sigma0 = 1e5, dahl.exponent = 1;
    undamped.friction.law = dahl;
    CHECK(says(undamped, "neutral"));
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
