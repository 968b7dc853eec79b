#include "sweep/report/figures/compare_maps.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

bool smooth(Region region)
{
    return region == Region::stable || region == Region::memory_only;
}

bool sticks(Region region)
{
    return region == Region::unstable || region == Region::velocity_only;
}

/// What both figures share: axes, boundaries, the design of the second run.
FieldMap field_over(const SweepComparison& c, const ComparedMap& compared)
{
    const auto &a = c.before.summary.slices[compared.slice], &b = c.after.summary.slices[compared.slice];
    FieldMap map;
    map.units = units_of(c.is.joint);
    const auto held = held_text(a.held, map.units), holds = held_text(b.held, map.units);
    map.fixed = held == holds ? holds : held + " before, " + holds + " after";
    map.x = b.x;
    map.y = b.y;
    const auto add = [&](const char* name, const Curve& curve, bool dashed) {
        if (!curve.x.empty()) map.lines.push_back({name, curve.x, curve.y, dashed});
    };
    add("boundary before", compared.before.boundary, true);
    add("boundary after", compared.after.boundary, false);
    for (const auto& fold : compared.before.folds) add("fold of limit cycles before", fold, true);
    for (const auto& fold : compared.after.folds) add("fold of limit cycles after", fold, false);
    map.design = compared.design;
    map.has_design = true;
    return map;
}

Figure class_figure(FieldMap map, const Slice& a, const Slice& b)
{
    map.title = "Change of each point, over (" + b.x.symbol + ", " + b.y.symbol + ")";
    map.name = "change";
    map.classes = {"smooth, as before", "stick-slip, as before",          "became smooth",
                   "became stick-slip", "bistable in one run or in both", "undecided in one of them"};
    for (std::size_t i = 0; i < a.region.size(); ++i)
        map.values.push_back(static_cast<double>(change_of(a.region[i], b.region[i])));
    const auto shares = change_shares(a, b);
    const auto gained = percent(shares[static_cast<std::size_t>(Change::became_smooth)]);
    const auto lost = percent(shares[static_cast<std::size_t>(Change::became_stick_slip)]);
    map.statement = gained + " of the chart became smooth, " + lost + " became stick-slip.";
    Figure figure;
    figure.id = chart_id("change", b.x, b.y);
    figure.finding = "Map of change over " + b.x.name + " and " + b.y.name + ": " + map.statement;
    figure.caption =
        "How to read it: the verdicts of the two runs are compared at each point of the grid. " + map.statement +
        " Dashed: boundaries before. Solid: boundaries after; between the points of the grid a class ends at them." +
        (map.fixed.empty() ? "" : " Held: " + map.fixed + ".");
    figure.picture = std::move(map);
    return figure;
}

Figure difference_figure(FieldMap map, const Slice& a, const Slice& b)
{
    map.title = "Change of the spectral abscissa over (" + b.x.symbol + ", " + b.y.symbol + ")";
    map.name = "after − before, max Re s";
    map.quantity = Quantity::rate;
    map.scale = FieldMap::Scale::diverging;
    map.none = "undecided in one of them";
    double low = 0, high = 0;
    for (std::size_t i = 0; i < a.abscissa.size(); ++i) {
        map.values.push_back(b.abscissa[i] - a.abscissa[i]);
        if (!std::isfinite(map.values.back())) continue;
        low = std::min(low, map.values.back());
        high = std::max(high, map.values.back());
    }
    map.statement = "Changes lie " + span_text(low, high, Quantity::rate, map.units) + ".";
    Figure figure;
    figure.id = chart_id("difference", b.x, b.y);
    figure.finding =
        "Difference map of the spectral abscissa over " + b.x.name + " and " + b.y.name + ". " + map.statement;
    figure.caption = "How to read it: blue decays faster than before (or grows more slowly), red decays more slowly. " +
                     map.statement;
    figure.picture = std::move(map);
    return figure;
}

}  // namespace

Change change_of(Region before, Region after)
{
    if (before == Region::undecided || after == Region::undecided) return Change::undecided;
    if (smooth(before) && smooth(after)) return Change::smooth;
    if (sticks(before) && sticks(after)) return Change::stick_slip;
    if (sticks(before) && smooth(after)) return Change::became_smooth;
    if (smooth(before) && sticks(after)) return Change::became_stick_slip;
    return Change::bistable;  // before, after or both times
}

std::array<double, changes> change_shares(const Slice& before, const Slice& after)
{
    const auto areas = area_shares(after.x, after.y);
    std::array<double, changes> shares{};
    for (std::size_t i = 0; i < areas.size(); ++i)
        shares[static_cast<std::size_t>(change_of(before.region[i], after.region[i]))] += areas[i];
    return shares;
}

std::vector<Figure> change_figures(const SweepComparison& c, const ComparedMap& map)
{
    const FieldMap field = field_over(c, map);
    const auto &a = c.before.summary.slices[map.slice], &b = c.after.summary.slices[map.slice];
    return {class_figure(field, a, b), difference_figure(field, a, b)};
}

}  // namespace stickslip
