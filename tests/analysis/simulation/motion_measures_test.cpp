// What is read off motions whose measures are known by construction.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "analysis/base/field.h"
#include "analysis/simulation/motion_measures.h"

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
