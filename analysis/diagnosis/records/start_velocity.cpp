#include "analysis/diagnosis/records/start_velocity.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

constexpr Eigen::Index coefficients = 4;  // of a cubic
constexpr std::size_t fewest_rows = 8, most_rows = 256;
constexpr double next_window = 1.4;  // numerical: of the scan
constexpr double of_a_grid = 0.25;   // numerical: share of readings that repeat the one before
constexpr double agreed = 3;  // numerical: standard errors of the shorter window: from there on the longer one is bent
/// Windows below the longest that agrees. Of it the bend is some standard errors, unseen; of half of it an eighth, and
/// the noise three times as much.
constexpr std::size_t windows_back = 2;

/// The first rows, from the first on.
struct Rows {
    std::vector<double> time, position;
};

Rows first_rows(const Ticks& t)
{
    Rows rows;
    for (std::size_t k = 0; k < t.size() && rows.time.size() < most_rows; ++k)
        if (t.logged[k]) rows.time.push_back(t.time[k] - t.time[0]), rows.position.push_back(t.position[k]);
    return rows;
}

/// Standard deviation of one reading: third differences of n independent ones have √20 of it, and a smooth motion next
/// to nothing. Readings that repeat lie on a grid, and are off by its step over √12.
double noise_of(const Rows& rows)
{
    const auto& q = rows.position;
    std::vector<double> third;
    double grid = infinity;
    std::size_t repeated = 0;
    for (std::size_t k = 3; k < q.size(); ++k) third.push_back(std::abs(q[k] - 3 * q[k - 1] + 3 * q[k - 2] - q[k - 3]));
    for (std::size_t k = 1; k < q.size(); ++k)
        if (q[k] != q[k - 1])
            grid = std::min(grid, std::abs(q[k] - q[k - 1]));
        else
            ++repeated;
    const auto middle = third.begin() + static_cast<std::ptrdiff_t>(third.size() / 2);
    std::nth_element(third.begin(), middle, third.end());
    constexpr double median_of_normal = 0.6745;  // numerical: of the normal distribution
    const double noise = *middle / (median_of_normal * std::sqrt(20.0));
    const bool on_grid = static_cast<double>(repeated) > of_a_grid * static_cast<double>(q.size()) && grid < infinity;
    return std::max(noise, on_grid ? grid / std::sqrt(12.0) : 0);
}

StartVelocity cubic_through(const Rows& rows, std::size_t count, double noise)
{
    const double length = rows.time[count - 1];
    const auto n = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd powers(n, coefficients);
    Eigen::VectorXd position(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const double s = rows.time[static_cast<std::size_t>(k)] / length;
        powers.row(k) << 1, s, s * s, s * s * s;
        position[k] = rows.position[static_cast<std::size_t>(k)] - rows.position[0];
    }
    const Eigen::Matrix4d normal = powers.transpose() * powers;
    const Eigen::Vector4d fitted = normal.ldlt().solve(powers.transpose() * position);
    return {fitted[1] / length, noise * std::sqrt(normal.inverse()(1, 1)) / length, 2 * fitted[2] / (length * length)};
}

}  // namespace

StartVelocity velocity_at_start(const Ticks& ticks)
{
    const Rows rows = first_rows(ticks);
    if (rows.time.size() < fewest_rows) return {};
    const double noise = noise_of(rows);
    std::vector<StartVelocity> shorter;
    for (std::size_t count = fewest_rows; count <= rows.time.size();
         count = static_cast<std::size_t>(next_window * static_cast<double>(count))) {
        const auto v = cubic_through(rows, count, noise);
        const bool bent = std::ranges::any_of(shorter, [&](const StartVelocity& before) {
            return std::abs(v.value - before.value) > agreed * before.error;
        });
        if (bent) break;
        shorter.push_back(v);
    }
    return shorter[shorter.size() - 1 - std::min(windows_back, shorter.size() - 1)];
}

void start_moving(Ticks& ticks)
{
    const auto start = velocity_at_start(ticks);
    ticks.at_rest = false;
    ticks.initial_velocity = start.value, ticks.initial_velocity_error = start.error;
    ticks.initial_acceleration = start.acceleration;
}

}  // namespace stickslip::gap
