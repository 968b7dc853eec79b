// Where a sequence of located points goes on. Internal to analysis/boundary.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>

namespace stickslip {

struct Foretold {
    double value = 0;
    double missed_by = 0;  ///< how far the same formula missed the last point of the sequence
};

/// The polynomial through the last `count` points, at t (Lagrange's form).
inline double through_last(std::span<const double> ts, std::span<const double> ys, std::size_t count, double t)
{
    double sum = 0;
    for (std::size_t i = ts.size() - count; i < ts.size(); ++i) {
        double weight = 1;
        for (std::size_t j = ts.size() - count; j < ts.size(); ++j)
            if (j != i) weight *= (t - ts[j]) / (ts[i] - ts[j]);
        sum += weight * ys[i];
    }
    return sum;
}

/// Continues y(t) to t by the polynomial of that degree which would have foretold the last point best. Needs two points
/// or more, t monotonic.
inline Foretold foretell(std::span<const double> ts, std::span<const double> ys, double t)
{
    constexpr std::size_t most_points = 6;
    const std::size_t n = ts.size();
    std::size_t best = 1;
    double least = HUGE_VAL;
    for (std::size_t count = 1; count <= std::min(n - 1, most_points); ++count) {
        const double missed = std::abs(through_last(ts.first(n - 1), ys.first(n - 1), count, ts[n - 1]) - ys[n - 1]);
        if (missed < least) least = missed, best = count;
    }
    return {through_last(ts, ys, best, t), least};
}

}  // namespace stickslip
