// Maps of joints, dense and with every point computed, for the test and the benchmark of both.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/joint/parameters.h"
#include "analysis/simulation/dense/dense_points.h"
#include "analysis/simulation/points.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

struct MapAxis {
    std::string path;
    double from, to;
    int points;
    bool log;

    std::vector<double> values() const
    {
        std::vector<double> v;
        for (int i = 0; i < points; ++i) {
            const double share = i / (points - 1.0);
            v.push_back(log ? from * std::pow(to / from, share) : from + (to - from) * share);
        }
        return v;
    }
};

/// A map and its joints.
struct Map {
    Joint joint;
    std::vector<MapAxis> axes;
    std::vector<std::vector<double>> values = {};
    std::vector<JointNumber> numbers = {};

    void prepare()
    {
        for (const auto& axis : axes) {
            values.push_back(axis.values());
            numbers.push_back(number_at(joint, axis.path));
        }
    }
    std::size_t points() const
    {
        std::size_t product = 1;
        for (const auto& v : values) product *= v.size();
        return product;
    }
    const Joint& at(std::size_t point)
    {
        for (std::size_t d = axes.size(); d-- > 0; point /= values[d].size())
            numbers[d] = values[d][point % values[d].size()];
        return joint;
    }
    DenseBox box()
    {
        DenseBox box;
        box.coordinates = values;
        for (std::size_t d = 0; d < axes.size(); ++d)
            if (axes[d].log)
                for (double& v : box.coordinates[d]) v = std::log(v);
        box.joint = [this](std::size_t point) -> const Joint& { return at(point); };
        return box;
    }
};

struct Comparison {
    std::size_t computed = 0, other_verdict = 0, other_bits = 0;
    double worst = 0;                       ///< of amplitude, period and largest velocity of the interpolated rows
    double share_at_rest = 0;               ///< the same, absolute
    double told = 0, told_of_computed = 0;  ///< largest interpolation_error
};

inline std::vector<PointResult> dense_rows(Map& map, const NonlinearOptions& options, double bound)
{
    std::vector<PointResult> rows(map.points());
    dense_points(map.box(), options, bound, rows);
    return rows;
}

/// Every point computed, as many at a time as a chunk of a sweep has.
inline std::vector<PointResult> computed_rows(Map& map, const NonlinearOptions& options)
{
    constexpr std::size_t chunk = 2048;
    std::vector<PointResult> rows(map.points());
    std::vector<Joint> joints;
    for (std::size_t first = 0; first < rows.size(); first += chunk) {
        const std::size_t count = std::min(chunk, rows.size() - first);
        joints.clear();
        for (std::size_t i = first; i < first + count; ++i) {
            joints.push_back(map.at(i));
            rows[i] = linear_point(joints.back());
        }
        nonlinear_points(joints, options, std::span(rows).subspan(first, count));
    }
    return rows;
}

inline Comparison compare(const std::vector<PointResult>& dense, const std::vector<PointResult>& every)
{
    Comparison found;
    for (std::size_t i = 0; i < every.size(); ++i) {
        const auto &a = dense[i], &b = every[i];
        found.other_verdict += a.outcome != b.outcome || a.region != b.region || a.reason != b.reason;
        const bool computed = a.path != DecisionPath::interpolation;
        found.computed += computed;
        const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
        if (computed) {
            found.other_bits += !(same(a.amplitude, b.amplitude) && same(a.period, b.period) && a.path == b.path &&
                                  same(a.velocity_min, b.velocity_min) && same(a.overshoot, b.overshoot));
            found.told_of_computed = std::max(found.told_of_computed, a.interpolation_error);
            continue;
        }
        found.told = std::max(found.told, a.interpolation_error);
        for (const double error : {same(a.amplitude, b.amplitude) ? 0 : a.amplitude / b.amplitude - 1,
                                   same(a.period, b.period) ? 0 : a.period / b.period - 1,
                                   same(a.velocity_max, b.velocity_max) ? 0 : a.velocity_max / b.velocity_max - 1})
            found.worst = std::max(found.worst, std::abs(error));
        if (!same(a.stick_fraction, b.stick_fraction))
            found.share_at_rest = std::max(found.share_at_rest, std::abs(a.stick_fraction - b.stick_fraction));
    }
    return found;
}

}  // namespace stickslip
