#include "sweep/study/compare/compare_sweeps.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "sweep/study/evaluate_points.h"
#include "sweep/study/map_answer.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

ComparedDesign design_of(const ComparedRun& run, const std::vector<Axis>& axes)
{
    ComparedDesign design;
    design.joint = design_joint(run.spec);
    design.verdict = linear_verdict(design.joint);
    PointResult row = linear_point(design.joint);
    const auto& nonlinear = run.spec.nonlinear;
    if (nonlinear.enabled) {
        const auto verdict = nonlinear_verdict(design.joint, nonlinear_options(nonlinear));
        write_nonlinear(verdict, row);
        design.rests = verdict.comes_to_rest();
    }
    design.region = row.region;
    for (const auto& axis : axes) design.margins.push_back(margin_along(design.joint, axis));
    return design;
}

ComparedCurves curves_over(const Joint& design, const Slice& slice)
{
    return {locate_over_chart(joint_at(design, slice.held), slice.x, slice.y, Curve::Kind::state_variable),
            large_disturbances(design, slice).folds};
}

bool same_values(const Slice& a, const Slice& b)
{
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.region == b.region &&
           std::equal(a.abscissa.begin(), a.abscissa.end(), b.abscissa.begin(), b.abscissa.end(), same);
}

}  // namespace

bool same_grid(const ComparedRun& before, const ComparedRun& after)
{
    const auto &a = before.spec.axes, &b = after.spec.axes;
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Axis& x, const Axis& y) {
               return x.path == y.path && x.values == y.values;
           });
}

SweepComparison compare_sweeps(ComparedRun before, ComparedRun after)
{
    SweepComparison c{std::move(before), std::move(after), {}, {}, false, {}};
    const auto& axes = c.before.spec.axes;
    c.was = design_of(c.before, axes), c.is = design_of(c.after, axes);
    c.comparable = same_grid(c.before, c.after) && units_of(c.was.joint) == units_of(c.is.joint);
    const auto &then = c.before.summary.slices, &now = c.after.summary.slices;
    for (std::size_t i = 0; c.comparable && i < then.size() && i < now.size(); ++i)
        if (!same_values(then[i], now[i]))
            c.maps.push_back({i, curves_over(c.was.joint, then[i]), curves_over(c.is.joint, now[i]),
                              design_point(c.is.joint, now[i])});
    return c;
}

}  // namespace stickslip
