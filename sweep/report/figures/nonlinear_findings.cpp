#include "sweep/report/figures/nonlinear_findings.h"

#include "analysis/boundary/kinds/boundary.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr const char* gain = "control.k_p";

struct Extent {
    double low = infinity, high = -infinity;
    void add(double value) { low = std::min(low, value), high = std::max(high, value); }
};

std::string extent_text(const Axis& axis, const Extent& extent, Motion motion)
{
    return axis.symbol + " = " + with_unit(extent.low, axis.quantity, motion) + " … " +
           with_unit(extent.high, axis.quantity, motion);
}

/// The fold that lies farthest beyond its critical gain.
struct Reach {
    double ratio = missing, k_p = missing, k_cr = missing, at = missing;  ///< `at`: on the other axis
};

Reach farthest(const Joint& design, const Slice& slice, const std::vector<Curve>& folds)
{
    const bool gain_is_x = slice.x.path == gain;
    Reach reach;
    if (!gain_is_x && slice.y.path != gain) return reach;
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

std::string reach_text(const Slice& slice, const Reach& reach, Motion motion)
{
    if (std::isnan(reach.ratio)) return "";
    const Axis& other = slice.x.path == gain ? slice.y : slice.x;
    return " The fold of limit cycles, beyond which none is left, lies up to " + plain_number(reach.ratio) +
           " times the critical gain away: at " + other.symbol + " = " + with_unit(reach.at, other.quantity, motion) +
           " the linear theory asks for k_{p} > " + with_unit(reach.k_cr, Quantity::stiffness, motion) +
           ", freedom from stick-slip for " + with_unit(reach.k_p, Quantity::stiffness, motion) + ".";
}

}  // namespace

NonlinearFindings nonlinear_findings(const Joint& design, const Slice& slice)
{
    NonlinearFindings found;
    const auto shares = area_shares(slice.x, slice.y);
    Extent x, y;
    double stable = 0;
    bool without_boundary = false;
    const std::size_t columns = slice.x.values.size();
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (slice.abscissa[i] < 0) stable += shares[i];
        if (slice.region[i] != Region::bistable) continue;
        found.bistable += shares[i];
        x.add(slice.x.values[i % columns]);
        y.add(slice.y.values[i / columns]);
    }
    if (found.bistable == 0) return found;
    found.of_linearly_stable = found.bistable / stable;
    const auto motion = design.mechanism.motion;
    BoundaryRequest request;
    request.kind = BoundaryKind::fold;
    auto fold = curve_of(follow_boundaries(joint_at(design, slice.held), slice.x, slice.y, request));
    if (!fold.x.empty()) found.folds.push_back(std::move(fold));
    const auto reach = farthest(design, slice, found.folds);
    found.reach = reach.ratio;
    // rows of the gain without a single linearly unstable point, but with bistable ones
    if (slice.x.path == gain)
        for (std::size_t row = 0; row < slice.y.values.size(); ++row) {
            const auto first = static_cast<std::ptrdiff_t>(row * columns),
                       last = first + static_cast<std::ptrdiff_t>(columns);
            const bool any_bistable =
                std::count(slice.region.begin() + first, slice.region.begin() + last, Region::bistable) > 0;
            const bool any_unstable = std::any_of(slice.abscissa.begin() + first, slice.abscissa.begin() + last,
                                                  [](double a) { return a > 0; });
            without_boundary |= any_bistable && !any_unstable;
        }
    found.text =
        "What the linear chart gets wrong: on " + percent(found.bistable) + " of the chart, " +
        percent(found.of_linearly_stable) +
        " of what it calls stable, small disturbances decay while a start from near rest ends in a limit cycle "
        "(bistable). These points lie within " +
        extent_text(slice.x, x, motion) + " and " + extent_text(slice.y, y, motion) + "." +
        reach_text(slice, reach, motion) +
        (without_boundary ? " Some of them lie where the linear theory sees no boundary along k_{p} at all." : "");
    return found;
}

}  // namespace stickslip
