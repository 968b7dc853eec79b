// What is read off motions whose measures are known by construction.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/base/field.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/motion_measures.h"
#include "analysis/simulation/simulate.h"
#include "tests/analysis/simulation/joints.h"

using namespace stickslip;

TEST_CASE("overshoot and settling time of a damped oscillation", "[simulation][measures]")
{
    // the step response of s² + 2 ζ ω s + ω²: overshoot exp(−π ζ/√(1−ζ²)), 2 % envelope
    const double zeta = 0.3, omega = 10, damped = omega * std::sqrt(1 - zeta * zeta);
    std::vector<double> time, reference, position;
    for (int i = 0; i <= 40000; ++i) {
        const double t = i * 1e-4 - 1e-4;
        time.push_back(t);
        reference.push_back(i == 0 ? 0 : -2);
        const double decay = t < 0 ? 1 : std::exp(-zeta * omega * t);
        position.push_back(
            t < 0 ? 0 : -2 * (1 - decay * (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t))));
    }
    const auto m = measure_motion(time, reference, position);
    CHECK(m.travel == -2);
    CHECK(m.overshoot == Approx(2 * std::exp(-M_PI * zeta / std::sqrt(1 - zeta * zeta))).epsilon(1e-4));
    REQUIRE(is_set(m.settling_time));
    CHECK(m.settling_time < std::log(50 / std::sqrt(1 - zeta * zeta)) / (zeta * omega));  // the envelope's own time
    CHECK(m.settling_time > 0.7 * std::log(50) / (zeta * omega));
}

TEST_CASE("stairs of slow motion: height and rate", "[simulation][measures]")
{
    std::vector<double> time, reference, position;
    for (int i = 0; i <= 40000; ++i) {
        const double t = i * 1e-4, stair = 0.5, slip = 0.05;
        time.push_back(t);
        reference.push_back(0.02 * t);
        const double phase = std::fmod(t, stair);
        position.push_back(0.02 * (t - phase) +
                           (phase > stair - slip ? 0.02 * stair * (phase - stair + slip) / slip : 0));
    }
    const auto m = measure_motion(time, reference, position);
    CHECK(m.stairs >= 7);
    CHECK(m.stair_height == Approx(0.01).epsilon(0.01));
    CHECK(m.stair_rate == Approx(2).epsilon(0.01));
    CHECK(!is_set(m.overshoot));
}

TEST_CASE("a joint that stands at its turning points makes no stairs", "[simulation][measures]")
{
    std::vector<double> time, reference, position;
    double place = 0;
    for (int i = 0; i <= 20000; ++i) {
        const double t = i * 1e-3, asked = 0.1 * std::sin(2 * t), play = 0.01;
        place = std::clamp(place, asked - play, asked + play);  // follows behind its friction
        time.push_back(t), reference.push_back(asked), position.push_back(place);
    }
    const auto m = measure_motion(time, reference, position);
    CHECK(m.stairs == 0);
    CHECK(!is_set(m.stair_height));
}

TEST_CASE("steps in which a position moves by less than its rounding are no stairs", "[simulation][measures]")
{
    // stairs of 0.4 m at 1 mm/s that drift on at 1 % of it, with 1000 rows of 1e-16 s where each slip begins
    std::vector<double> time, reference, position;
    const auto add = [&](double t, double y) {
        if (!time.empty() && t <= time.back()) return;
        time.push_back(t), reference.push_back(1e-3 * t), position.push_back(y);
    };
    for (int stair = 0; stair < 8; ++stair) {
        const double t0 = 400 * stair, y0 = 0.4 * stair;
        for (int i = 0; i < 390; ++i) add(t0 + i, y0 + 1e-5 * i);
        for (int i = 1; i < 1000; ++i) add(t0 + 389 + i * 1e-13, y0 + 389e-5 + i * 1e-15);
        for (int i = 0; i < 100; ++i) add(t0 + 390 + i * 0.1, y0 + 3.9e-3 + 0.3961 * i / 100);
    }
    const auto m = measure_motion(time, reference, position);
    CHECK(m.stairs == 7);
    CHECK(m.stair_height == Approx(0.4).epsilon(1e-2));
    CHECK(m.stair_rate == Approx(1 / 400.0).epsilon(1e-2));
}

TEST_CASE("stairs of relaxation cycles are those that its verdict tells, and times rise", "[simulation][measures]")
{
    Joint joint = example_joint(200, 10, 1e-3);
    auto& law = std::get<RateAndState>(joint.friction.law);
    law.B[0] = 5;
    const auto verdict = nonlinear_verdict(joint, {});
    REQUIRE(is_set(verdict.period));
    SimulateOptions options;
    options.duration = 5 * verdict.period;
    const auto path = simulate(joint, options);
    REQUIRE(path.reason == Reason::none);
    CHECK(std::adjacent_find(path.time.begin(), path.time.end(), std::greater_equal<>()) == path.time.end());
    std::vector<double> reference, position;
    for (std::size_t i = 0; i < path.time.size(); ++i) {
        reference.push_back(1e-3 * path.time[i]);
        position.push_back(reference.back() + path.position[i]);
    }
    // from the second cycle on: the first begins with the spring that steady sliding stretches
    const auto from = static_cast<std::size_t>(std::upper_bound(path.time.begin(), path.time.end(), verdict.period) -
                                               path.time.begin());
    const auto rows = [from](const std::vector<double>& all) { return std::span(all).subspan(from); };
    const auto m = measure_motion(rows(path.time), rows(reference), rows(position));
    CHECK(m.stair_rate == Approx(1 / verdict.period).epsilon(1e-2));
    CHECK(m.stair_height == Approx(1e-3 * verdict.period).epsilon(1e-2));
}

TEST_CASE("what an encoder reads of a smooth motion has no stairs", "[simulation][measures]")
{
    constexpr double step = 1e-4, noise = 2e-5;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<double> time, reference, smooth, stepping;
    for (int k = 0; k < 20000; ++k) {
        const double t = 1e-3 * k, stair = 0.02;
        time.push_back(t), reference.push_back(5e-3 * t);
        const auto read = [&](double q) { return step * std::round((q + noise * normal(random)) / step); };
        smooth.push_back(read(reference.back()));
        stepping.push_back(read(stair * std::floor(reference.back() / stair)));
    }
    const double error = 0.5 * step + 4 * noise;
    CHECK(measure_motion(time, reference, smooth).stairs > 0);  // of the encoder
    CHECK(measure_motion(time, reference, smooth, error).stairs == 0);
    const auto m = measure_motion(time, reference, stepping, error);
    CHECK(m.stairs >= 3);
    CHECK(m.stair_height == Approx(0.02).epsilon(0.01));
}
