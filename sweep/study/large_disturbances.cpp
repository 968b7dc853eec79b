#include "sweep/study/large_disturbances.h"

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

FoldReach farthest(const Joint& design, const Slice& slice, const std::vector<Curve>& folds)
{
    const bool gain_is_x = slice.x.path == gain_path;
    FoldReach reach;
    if (!gain_is_x && slice.y.path != gain_path) return reach;
    const Axis& other = gain_is_x ? slice.y : slice.x;
    const Joint held = joint_at(design, slice.held);
    for (const auto& curve : folds)
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const double k_p = gain_is_x ? curve.x[i] : curve.y[i], at = gain_is_x ? curve.y[i] : curve.x[i];
            if (std::isnan(k_p)) continue;
            Axis axis = other;
            axis.values.clear();
            const double k_cr = linear_point(joint_at(held, {{axis, at}})).k_cr;
            if (!(k_cr > 0) || k_p / k_cr <= reach.ratio) continue;
            reach = {k_p / k_cr, k_p, k_cr, at};
        }
    return reach;
}

}  // namespace

LargeDisturbances large_disturbances(const Joint& design, const Slice& slice)
{
    LargeDisturbances found;
    const auto shares = area_shares(slice.x, slice.y);
    double stable = 0;
    const std::size_t columns = slice.x.values.size();
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (slice.abscissa[i] < 0) stable += shares[i];
        if (slice.region[i] != Region::bistable) continue;
        found.bistable += shares[i];
        found.x.add(slice.x.values[i % columns]);
        found.y.add(slice.y.values[i / columns]);
    }
    if (found.bistable == 0) return found;
    found.of_linearly_stable = found.bistable / stable;
    // folds that only simulation tells take some ten motions a point: the map shows the area, `boundary` its edge
    const Joint held = joint_at(design, slice.held);
    if (has_smooth_orbits(held, {slice.x, slice.y})) {
        BoundaryRequest request;
        request.kind = BoundaryKind::fold;
        auto fold = curve_of(follow_boundaries(held, slice.x, slice.y, request));
        if (!fold.x.empty()) found.folds.push_back(std::move(fold));
        found.reach = farthest(design, slice, found.folds);
    }
    // rows of the gain without a single linearly unstable point, but with bistable ones
    if (slice.x.path == gain_path)
        for (std::size_t row = 0; row < slice.y.values.size(); ++row) {
            const auto first = static_cast<std::ptrdiff_t>(row * columns),
                       last = first + static_cast<std::ptrdiff_t>(columns);
            const bool any_bistable =
                std::count(slice.region.begin() + first, slice.region.begin() + last, Region::bistable) > 0;
            const bool any_unstable = std::any_of(slice.abscissa.begin() + first, slice.abscissa.begin() + last,
                                                  [](double a) { return a > 0; });
            found.without_boundary |= any_bistable && !any_unstable;
        }
    return found;
}

}  // namespace stickslip
