// What a computed load is wrong by, against closed forms of its two parts: noise of the readings and corners that are
// rounded.
#include <catch2/catch.hpp>

#include "analysis/numerics/seeded_noise.h"
#include "sweep/study/import/arm_load.h"

#include <cmath>

using namespace stickslip;

namespace {

constexpr double step = 2e-3, window = 0.03;
constexpr int rows = 15;  // within the window

std::vector<double> clock_of(std::size_t n)
{
    std::vector<double> time(n);
    for (std::size_t k = 0; k < n; ++k) time[k] = step * static_cast<double>(k);
    return time;
}

}  // namespace

TEST_CASE("accelerations measured again scatter as a cubic's do", "[import]")
{
    constexpr double sigma = 3e-5;
    const auto time = clock_of(20000);
    SeededNoise noise(4);
    std::vector<double> readings;
    for (const double t : time) readings.push_back(std::sin(t) + sigma * noise());
    const auto motion = smoothed(time, readings, window);
    const auto again = measured_again(time, readings, motion, window, 1);
    double sum = 0;
    for (std::size_t k = 100; k + 100 < time.size(); ++k)
        sum += std::pow(again.acceleration[k] - motion.acceleration[k], 2);
    // least squares on n even rows: var a = 720 σ²/(n(n² − 1)(n² − 4)h⁴)
    const double n = rows;
    const double expected = sigma * std::sqrt(720 / (n * (n * n - 1) * (n * n - 4))) / (step * step);
    // the motion taken for true is itself noisy, and smearing it again takes some of that away
    const double found = std::sqrt(sum / static_cast<double>(time.size() - 200));
    CHECK(found > expected);
    CHECK(found < 1.5 * expected);
}

TEST_CASE("a corner is wrong again by what it was wrong by, in the position that follows from it", "[import]")
{
    constexpr double jump = 5;  // of the acceleration, after 1 s
    const auto time = clock_of(1001);
    std::vector<double> position, acceleration;
    for (const double t : time) {
        const double s = std::max(0.0, t - 1);
        position.push_back(0.5 * jump * s * s);
        acceleration.push_back(t > 1 ? jump : t < 1 ? 0 : jump / 2);
    }
    const auto motion = smoothed(time, position, window);
    const auto again = measured_again(time, position, motion, window, 1);
    const auto moved_by = [&](const std::vector<double>& right, const std::vector<double>& wrong) {
        double v = 0, q = 0;
        for (std::size_t k = 100; k + 100 < time.size(); ++k) q += step * (v += step * (wrong[k] - right[k]));
        return q;
    };
    // weights (1 − (2s/w)²)² have the second moment w²/28
    const double expected = jump * window * window / 56;
    CHECK(moved_by(motion.acceleration, again.acceleration) == Approx(expected).epsilon(0.15));
    CHECK(moved_by(acceleration, motion.acceleration) == Approx(expected).epsilon(0.15));  // the first time, too
}
