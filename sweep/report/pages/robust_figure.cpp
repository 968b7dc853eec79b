#include "sweep/report/pages/robust_figure.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/files/toml/spec_file.h"
#include "sweep/report/pages/boundary_report.h"
#include "sweep/study/samples.h"
#include "sweep/words/verdict_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr int chart_columns = 161, chart_rows = 121;  ///< as fine as the lines are wide
constexpr double aside = 1e-3;                        ///< of a row's height
enum Class { robust = 0, unstable = 1, nominal_only = 2, no_verdict = 5 };

/// Where the curve crosses the row at y, ascending.
std::vector<double> crossings(const Curve& curve, double y)
{
    std::vector<double> found;
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
        const double a = curve.y[i - 1], b = curve.y[i];
        if (std::isnan(a) || std::isnan(b) || (a < y) == (b < y)) continue;
        found.push_back(curve.x[i - 1] + (y - a) / (b - a) * (curve.x[i] - curve.x[i - 1]));
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Whether each node of a row is stable: known at its left end, changing at each crossing.
std::vector<bool> row_of(const std::vector<double>& x, const std::vector<double>& crossings, bool stable_at_left)
{
    std::vector<bool> stable;
    for (const double v : x) {
        const auto passed = std::lower_bound(crossings.begin(), crossings.end(), v) - crossings.begin();
        stable.push_back(stable_at_left != (passed % 2 == 1));
    }
    return stable;
}

void classify(FieldMap& map, const MarginsAnswer& a)
{
    const auto robust_curve = curve_of(*a.robust), nominal_curve = curve_of(*a.nominal);
    Joint joint = a.joint;
    *find_parameter(joint, map.x.path) = map.x.values.front();
    double& y = *find_parameter(joint, map.y.path);
    const auto& ys = map.y.values;
    for (std::size_t j = 0; j < ys.size(); ++j) {
        // curves end on the borders: their rows are taken a little within
        const double v = j == 0               ? ys[0] + aside * (ys[1] - ys[0])
                         : j + 1 == ys.size() ? ys[j] - aside * (ys[j] - ys[j - 1])
                                              : ys[j];
        y = v;
        const double described = instability(joint, Curve::Kind::state_variable);
        const double worst = worst_case(joint, a.uncertainty, Curve::Kind::state_variable, false).instability;
        const auto stable = row_of(map.x.values, crossings(nominal_curve, v), described < 0);
        const auto always = row_of(map.x.values, crossings(robust_curve, v), worst < 0);
        const bool told = !std::isnan(described) && !std::isnan(worst);
        for (std::size_t i = 0; i < stable.size(); ++i)
            map.values.push_back(!told ? no_verdict : always[i] ? robust : stable[i] ? nominal_only : unstable);
    }
}

}  // namespace

Figure robust_figure(const MarginsAnswer& a)
{
    FieldMap map;
    map.units = units_of(a.joint);
    map.x = a.robust->x, map.y = a.robust->y;
    map.x.values = spaced(map.x.values.front(), map.x.values.back(), chart_columns, map.x.log);
    map.y.values = spaced(map.y.values.front(), map.y.values.back(), chart_rows, map.y.log);
    map.title = "Robustly stable set over (" + map.x.symbol + ", " + map.y.symbol + ")";
    map.name = "stability within the uncertainty";
    map.classes = {"smooth in every joint of the uncertainty",
                   "stick-slip in the joint as described",
                   "smooth as described, stick-slip in the worst case",
                   "",
                   "",
                   "no verdict"};
    classify(map, a);
    const auto share = [&](Class c) {
        return percent(static_cast<double>(std::count(map.values.begin(), map.values.end(), static_cast<double>(c))) /
                       static_cast<double>(map.values.size()));
    };
    map.statement = share(robust) + " of this chart is robustly smooth, " + share(nominal_only) +
                    " only in the joint as described.";
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
