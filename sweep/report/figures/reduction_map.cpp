#include "sweep/report/figures/reduction_map.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/report/figures/map_figures.h"

#include <algorithm>

namespace stickslip {

Figure reduction_map(const Slice& slice, const ReducedMap& map, Units units)
{
    LineChart chart;
    chart.title = "Boundary of the full joint and of its reductions";
    chart.fixed = held_text(slice.held, units);
    chart.x_label = axis_label(slice.x.name + " " + slice.x.symbol, slice.x.quantity, units);
    chart.y_label = axis_label(slice.y.name + " " + slice.y.symbol, slice.y.quantity, units);
    chart.x_log = slice.x.log, chart.y_log = slice.y.log;
    chart.lines.push_back({"full joint", map.full.x, map.full.y, false});
    std::string errors;
    for (const auto& c : map.models) {
        errors += " " + c.model + " (assumes " + c.assumption + "): wrong on " + percent(c.wrong()) +
                  " of the chart, stable by mistake on " + percent(c.wrong_stable) + ".";
        if (c.boundary.x.empty()) errors += " It has no boundary here.";
        if (!c.boundary.x.empty()) chart.lines.push_back({c.model, c.boundary.x, c.boundary.y, true});
    }
    const auto best = std::min_element(map.models.begin(), map.models.end(),
                                       [](const auto& a, const auto& b) { return a.wrong() < b.wrong(); });
    const std::string finding = "Of the reductions, " + best->model + " is the best on this chart: wrong on " +
                                percent(best->wrong()) + " of it.";
    return line_figure(chart_id("reductions", slice.x, slice.y), std::move(chart), finding,
                       "Solid: the full joint, with memory. Dashed: what each reduction of Figs. 4 to 7 makes of it, "
                       "each point reduced separately. Where the curves differ, the assumption does not hold." +
                           errors + " Shares are of the chart's area, from verdicts on " + std::to_string(map.columns) +
                           " × " + std::to_string(map.rows) + " places.");
}

}  // namespace stickslip
