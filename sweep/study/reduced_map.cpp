#include "sweep/study/reduced_map.h"

#include "analysis/boundary/trace/follow.h"
#include "analysis/joint/parameters.h"
#include "analysis/stability/reduction_study.h"
#include "analysis/stability/verdict.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace stickslip {
namespace {

constexpr std::size_t most_nodes = 64;  ///< along an axis, of the grid on which verdicts are compared

using GrowthAt = std::function<double(double x, double y)>;

/// max Re s at a place of the chart, of the joint there or of what `reduce` makes of it; NaN where it refuses.
GrowthAt growth_over(const Joint& joint, const Slice& slice, std::function<Reduction(const Joint&)> reduce)
{
    return [joint, &slice, reduce = std::move(reduce)](double x, double y) {
        Joint there = joint;
        number_at(there, slice.x.path) = x;
        number_at(there, slice.y.path) = y;
        try {
            return reduce ? growth_rate(reduce(there)) : growth_rate(there);
        } catch (const std::invalid_argument&) {
            return missing;
        }
    };
}

/// An axis with so few values that comparing verdicts at all of them is cheap.
Axis thinned(Axis axis)
{
    const auto all = axis.values;
    if (all.size() <= most_nodes) return axis;
    axis.values.clear();
    for (std::size_t i = 0; i < most_nodes; ++i) axis.values.push_back(all[i * (all.size() - 1) / (most_nodes - 1)]);
    return axis;
}

Samples boundary_line(const GrowthAt& growth, const Slice& slice)
{
    Sides sides;
    sides.at = growth;
    auto curve = curve_of(follow_boundary(sides, slice.x, slice.y, {}));
    return {std::move(curve.x), std::move(curve.y)};
}

/// Signs of the growth on a grid, row-major with x fastest: 1 unstable, −1 stable, 0 no verdict.
std::vector<int> signs(const GrowthAt& growth, const Axis& x, const Axis& y)
{
    std::vector<int> all(x.values.size() * y.values.size());
    tbb::parallel_for(std::size_t{0}, y.values.size(), [&](std::size_t iy) {
        for (std::size_t ix = 0; ix < x.values.size(); ++ix) {
            const double s = growth(x.values[ix], y.values[iy]);
            all[iy * x.values.size() + ix] = std::isnan(s) ? 0 : s < 0 ? -1 : 1;
        }
    });
    return all;
}

}  // namespace

std::optional<ReducedMap> compare_reductions(const Joint& design, const Slice& slice)
{
    if (design.mechanism.model == Model::single_mass) return std::nullopt;
    const Joint joint = joint_at(design, slice.held);
    const auto full = growth_over(joint, slice, {});
    const Axis x = thinned(slice.x), y = thinned(slice.y);
    const auto truth = signs(full, x, y);
    const auto shares = area_shares(x, y);
    ReducedMap map;
    for (const auto& reduction : reductions_of(joint)) {
        ReducedModel c;
        try {
            c.model = reduction.reduce(joint).model;
        } catch (const std::invalid_argument&) {
            continue;  // the section on reductions says why
        }
        c.assumption = reduction.assumption;
        const auto growth = growth_over(joint, slice, reduction.reduce);
        c.boundary = boundary_line(growth, slice);
        const auto judged = signs(growth, x, y);
        for (std::size_t i = 0; i < judged.size(); ++i) {
            if (judged[i] * truth[i] >= 0) continue;
            (judged[i] < 0 ? c.wrong_stable : c.wrong_unstable) += shares[i];
        }
        map.models.push_back(std::move(c));
    }
    if (map.models.empty()) return std::nullopt;
    map.full = boundary_line(full, slice);
    map.columns = x.values.size(), map.rows = y.values.size();
    return map;
}

}  // namespace stickslip
