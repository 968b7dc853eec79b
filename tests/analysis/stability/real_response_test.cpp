// Forces, noise and gains of real loops against controllers and mechanisms that are written out here, and every answer
// about one joint against the others.
#include "analysis/stability/real_response.h"
#include "analysis/design/noise.h"
#include "analysis/stability/comparison.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/study.h"
#include "tests/analysis/simulation/joints.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

using namespace stickslip;

namespace {

/// A mass with viscous friction, whose motion over a constant force is written out below.
Joint viscous_joint()
{
    Joint joint = example_joint(2e4, 150, 1e-3);
    joint.friction.law = CoulombViscous{1, 12};
    joint.control.velocity_estimate = {EstimateForm::backward_difference, 2e-3, 1};
    joint.control.period = 1e-3;
    joint.control.delay = 1e-3;
    return joint;
}

/// The same loop by hand: read, difference, filter, command of the last tick, and steps of the mass short enough for
/// any force.
struct ByHand {
    double x = 0, v = 0, last = 0, estimate = 0, command = 0;

    template <class Force>
    void tick(int index, double noise, const Force& force, int substeps)
    {
        constexpr double T = 1e-3, tau = 2e-3, m = 1, c = 12, k_p = 2e4, k_v = 150;
        const double reading = x + noise;
        estimate += T / (tau + T) * ((reading - last) / T - estimate);
        last = reading;
        const double acting = command;  // one tick late
        command = -k_p * reading - k_v * estimate;
        const double h = T / substeps;
        for (int i = 0; i < substeps; ++i) {
            const double t = index * T + i * h;
            const auto rate = [&](double at, double speed) { return (acting + force(t + at) - c * speed) / m; };
            // classical Runge-Kutta of fourth order
            const double a1 = rate(0, v), a2 = rate(h / 2, v + h / 2 * a1), a3 = rate(h / 2, v + h / 2 * a2),
                         a4 = rate(h, v + h * a3);
            x += h * (v + h / 6 * (a1 + a2 + a3));
            v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
        last_command = command;
    }
    double last_command = 0;
};

}  // namespace

TEST_CASE("A sampled loop answers a sine of force as its mass and controller do tick by tick", "[loop]")
{
    const auto response = LoopResponse::of(viscous_joint(), Theory::state_variable);
    REQUIRE(response);
    for (const double omega : {3.0, 90.0, 400.0, 1500.0}) {
        ByHand loop;
        const auto force = [&](double t) { return std::cos(omega * t); };
        const int settle = 4000, watched = 20000;
        double cc = 0, ss = 0, cs = 0, xc = 0, xs = 0;
        for (int k = 0; k < settle + watched; ++k) {
            if (k >= settle) {
                const double C = std::cos(omega * k * 1e-3), S = std::sin(omega * k * 1e-3);
                cc += C * C, ss += S * S, cs += C * S, xc += loop.x * C, xs += loop.x * S;
            }
            loop.tick(k, 0, force, 32);
        }
        const double det = cc * ss - cs * cs;
        const std::complex<double> seen((xc * ss - xs * cs) / det, -(xs * cc - xc * cs) / det);
        INFO("omega " << omega);
        CHECK(std::abs(response->at(omega) - seen) < 1e-7 * std::abs(seen));
    }
    CHECK(std::abs(response->at(0)) == Approx(1 / 2e4).epsilon(1e-12));
}

TEST_CASE("A sampled loop under a held force is the loop tick by tick", "[loop]")
{
    const auto response = LoopResponse::of(viscous_joint(), Theory::state_variable);
    REQUIRE(response);
    const auto force = sampled_force(ForceKind::step, 5, 0.2, 1e-3);
    const auto answer = response->forced(force);
    ByHand loop;
    for (std::size_t k = 0; k < answer.time.size(); ++k) {
        CHECK(answer.position[k] == Approx(loop.x).epsilon(1e-9).margin(1e-16));
        loop.tick(
            static_cast<int>(k), 0, [](double) { return 5.0; }, 8);
    }
}

TEST_CASE("Noise of a sampled loop is that of a seeded run of it", "[loop][noise]")
{
    const Joint joint = viscous_joint();
    const auto response = LoopResponse::of(joint, Theory::state_variable);
    REQUIRE(response);
    SensorNoise noise;
    noise.position = 2e-6;
    noise.period = 1e-3;
    noise.filter = 2e-3;
    const auto foretold = loop_noise(joint, *response, noise);
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    ByHand loop;
    double xx = 0, uu = 0;
    const int settle = 2000, watched = 2000000;
    for (int k = 0; k < settle + watched; ++k) {
        if (k >= settle) xx += loop.x * loop.x;
        loop.tick(
            k, noise.position * normal(random), [](double) { return 0.0; }, 1);
        if (k >= settle) uu += loop.last_command * loop.last_command;
    }
    CHECK(foretold.motion == Approx(std::sqrt(xx / watched)).epsilon(0.01));
    CHECK(foretold.effort == Approx(std::sqrt(uu / watched)).epsilon(0.01));
}

TEST_CASE("Dead time in a continuous loop answers forces by its quasi-polynomial", "[loop]")
{
    Joint joint = viscous_joint();
    joint.control.period = not_set;
    joint.control.velocity_estimate = {};
    joint.control.delay = 3e-3;
    const auto response = LoopResponse::of(joint, Theory::state_variable);
    REQUIRE(response);
    for (const double omega : {0.0, 20.0, 140.0, 900.0}) {
        const std::complex<double> s(0, omega);
        const auto expected = 1.0 / (s * s + 12.0 * s + (2e4 + 150.0 * s) * std::exp(-3e-3 * s));
        CHECK(std::abs(response->at(omega) - expected) < 1e-11 * std::abs(expected));
    }
    // in time: the force's steady end, and the work of an impulse, ∫x dt = 1/k_p
    const auto step = response->forced(sampled_force(ForceKind::step, 4, 2, 1e-3));
    CHECK(step.position.back() == Approx(4 / 2e4).epsilon(1e-9));
    const auto impulse = response->forced(sampled_force(ForceKind::impulse, 1, 2, 1e-4));
    double sum = 0;
    for (const double x : impulse.position) sum += x * 1e-4;
    CHECK(sum == Approx(1 / 2e4).epsilon(1e-4));
}

TEST_CASE("A force on a link beside a neighbour is answered in time as in frequency", "[loop]")
{
    Joint joint = example_joint(2e5, 40, 1e-3);
    joint.neighbour.push_back({0.5, 0.3, 2e3, 5});
    const auto response = LoopResponse::of(joint, Theory::state_variable);
    REQUIRE(response);
    const double omega = 150;
    const auto answer = response->forced(sampled_force(ForceKind::sine, 1, 6, 1e-5, omega));
    double largest = 0;
    for (std::size_t i = answer.time.size() - 5000; i < answer.time.size(); ++i)
        largest = std::max(largest, std::abs(answer.position[i]));
    CHECK(largest == Approx(std::abs(response->at(omega))).epsilon(1e-3));
}

TEST_CASE("What is said of one real loop agrees: windows, locus, margins, demands", "[loop][slow]")
{
    for (const double k_p : {4e4, 8e4, 3e5}) {
        for (const int kind : {0, 1, 2}) {
            Joint joint = example_joint(k_p, 20, 1e-3);
            joint.control.velocity_estimate = {EstimateForm::backward_difference, 1e-3, 1};
            if (kind < 2) joint.control.period = 5e-4;
            if (kind > 0) joint.control.delay = 7e-4;
            if (kind == 2) joint.actuator.lag = 1e-3;
            INFO("k_p " << k_p << " kind " << kind);
            const auto verdict = linear_verdict(joint);
            const auto& memory = verdict.state_variable;
            const auto study = linear_study(joint);
            const auto& windows = study.comparison.k_p_memory;
            REQUIRE(windows.size() == memory.stable_intervals.size());
            for (std::size_t i = 0; i < windows.size(); ++i) CHECK(windows[i].low == memory.stable_intervals[i].low);
            const auto holds = [](const std::vector<Interval>& set, double value) {
                return std::any_of(set.begin(), set.end(),
                                   [&](const Interval& i) { return i.low < value && value < i.high; });
            };
            CHECK(holds(windows, k_p) == memory.stable);
            CHECK(holds(study.comparison.k_v_memory, 20) == memory.stable);
            CHECK(holds(study.comparison.k_v_velocity_only, 20) == verdict.velocity_only.stable);
            CHECK(std::isnan(study.peak.magnitude) != memory.stable);
            // every demand over all velocities holds at one
            Joint damped = joint;
            for (const auto& i : study.range_gain->stable_k_v)
                if (i.high < 1e9) {
                    damped.control.k_v = (i.low + i.high) / 2;
                    CHECK(linear_verdict(damped).velocity_only.stable);
                }
            const auto row = root_locus(joint, {k_p}).front();
            double rightmost = -infinity;
            for (const auto& s : row) rightmost = std::max(rightmost, s.real());
            CHECK(rightmost == Approx(memory.spectral_abscissa).epsilon(1e-9));
        }
    }
}

TEST_CASE("Short ticks answer as the ideal loop", "[loop]")
{
    Joint ideal = viscous_joint();
    ideal.control.velocity_estimate = {};
    ideal.control.period = not_set;
    ideal.control.delay = 0;
    Joint sampled = viscous_joint();
    sampled.control.period = 1e-7;
    sampled.control.delay = 0;
    sampled.control.velocity_estimate = {EstimateForm::exact, 0, 1};
    const auto a = LoopResponse::of(ideal, Theory::state_variable),
               b = LoopResponse::of(sampled, Theory::state_variable);
    REQUIRE((a && b));
    for (const double omega : {0.0, 30.0, 140.0})
        CHECK(std::abs(a->at(omega) - b->at(omega)) < 1e-4 * std::abs(a->at(omega)));
    CHECK(a->peak().magnitude == Approx(b->peak().magnitude).epsilon(1e-4));
}
