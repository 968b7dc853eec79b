#include "sweep/report/pages/robust_figure.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/report/pages/boundary_report.h"

#include <algorithm>

namespace stickslip {
namespace {

/// The place of a class in the legend of a map with classes.
double legend_place(RobustClass c)
{
    switch (c) {
        case RobustClass::robust:
            return 0;
        case RobustClass::unstable:
            return 1;
        case RobustClass::nominal_only:
            return 2;
        case RobustClass::no_verdict:
            break;
    }
    return 5;  // no_verdict: places 3 and 4 of the colours of classes stand for nothing here
}

}  // namespace

Figure robust_figure(const MarginsAnswer& a)
{
    FieldMap map;
    map.units = units_of(a.joint);
    map.x = a.robust_set->x, map.y = a.robust_set->y;
    map.title = "Robustly stable set over (" + map.x.symbol + ", " + map.y.symbol + ")";
    map.name = "stability within the uncertainty";
    map.classes = {"smooth in every joint of the uncertainty",
                   "stick-slip in the joint as described",
                   "smooth as described, stick-slip in the worst case",
                   "",
                   "",
                   "no verdict"};
    const auto& classes = a.robust_set->classes;
    for (const RobustClass c : classes) map.values.push_back(legend_place(c));
    const auto share = [&](RobustClass c) {
        return percent(static_cast<double>(std::count(classes.begin(), classes.end(), c)) /
                       static_cast<double>(classes.size()));
    };
    map.statement = share(RobustClass::robust) + " of this chart is robustly smooth, " +
                    share(RobustClass::nominal_only) + " only in the joint as described.";
    const auto add = [&](const char* name, const FollowedBoundary& boundary, bool dashed) {
        auto curve = curve_of(boundary);
        if (!curve.x.empty()) map.lines.push_back({name, std::move(curve.x), std::move(curve.y), dashed});
    };
    add("edge of the worst case", *a.robust, false);
    add("boundary as described", *a.nominal, true);
    Joint joint = a.joint;
    auto& d = map.design;
    d.x = *find_parameter(joint, map.x.path), d.y = *find_parameter(joint, map.y.path);
    d.inside = d.x >= map.x.values.front() && d.x <= map.x.values.back() && d.y >= map.y.values.front() &&
               d.y <= map.y.values.back();
    map.has_design = true;
    Figure figure;
    figure.id = "robust-set";
    figure.caption =
        "Plain: every joint of the uncertainty slides. Gold hatching: the joint as described slides, the worst case "
        "does "
        "not. Both edges are located point by point, to " +
        plain_number(a.robust->precision(), 2) +
        " relative. Not excluded by this search: " + could_be_missed(*a.robust) + ".";
    figure.finding = map.title + ": " + map.statement;
    figure.picture = std::move(map);
    return figure;
}

}  // namespace stickslip
