#include "sweep/report/figures/reduction_map.h"

#include "analysis/boundary/trace/follow.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "analysis/stability/reduction_study.h"
#include "analysis/stability/verdict.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/words/line_figure.h"

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
        *find_parameter(there, slice.x.path) = x;
        *find_parameter(there, slice.y.path) = y;
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

LineChart::Line boundary_line(const GrowthAt& growth, const Slice& slice, std::string name)
{
    Sides sides;
    sides.at = growth;
    const auto curve = curve_of(follow_boundary(sides, slice.x, slice.y, {}));
    return {std::move(name), curve.x, curve.y, true};
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

/// One reduction over the chart.
struct Compared {
    std::string model, assumption;
    LineChart::Line line;
    double wrong_stable = 0, wrong_unstable = 0;  ///< shares of the chart that it calls so wrongly
};

}  // namespace

std::optional<Figure> reduction_map(const Joint& design, const Slice& slice)
{
    if (design.mechanism.model == Model::single_mass) return std::nullopt;
    const auto motion = design.mechanism.motion;
    const Joint joint = joint_at(design, slice.held);
    const auto full = growth_over(joint, slice, {});
    const Axis x = thinned(slice.x), y = thinned(slice.y);
    const auto truth = signs(full, x, y);
    const auto shares = area_shares(x, y);
    std::vector<Compared> all;
    for (const auto& reduction : reductions_of(joint)) {
        Compared c;
        try {
            const auto reduced = reduction.reduce(joint);
            c.model = reduced.model;
        } catch (const std::invalid_argument&) {
            continue;  // the section on reductions says why
        }
        c.assumption = reduction.assumption;
        const auto growth = growth_over(joint, slice, reduction.reduce);
        c.line = boundary_line(growth, slice, c.model);
        const auto judged = signs(growth, x, y);
        for (std::size_t i = 0; i < judged.size(); ++i) {
            if (judged[i] * truth[i] >= 0) continue;
            (judged[i] < 0 ? c.wrong_stable : c.wrong_unstable) += shares[i];
        }
        all.push_back(std::move(c));
    }
    if (all.empty()) return std::nullopt;
    LineChart chart;
    chart.title = "Boundary of the full joint and of its reductions";
    chart.fixed = held_text(slice.held, motion);
    chart.x_label = axis_label(slice.x.name + " " + slice.x.symbol, slice.x.quantity, motion);
    chart.y_label = axis_label(slice.y.name + " " + slice.y.symbol, slice.y.quantity, motion);
    chart.x_log = slice.x.log, chart.y_log = slice.y.log;
    chart.lines.push_back(boundary_line(full, slice, "full joint"));
    chart.lines.back().dashed = false;
    std::string errors;
    for (auto& c : all) {
        errors += " " + c.model + " (assumes " + c.assumption + "): wrong on " +
                  percent(c.wrong_stable + c.wrong_unstable) + " of the chart, stable by mistake on " +
                  percent(c.wrong_stable) + ".";
        if (c.line.x.empty()) errors += " It has no boundary here.";
        if (!c.line.x.empty()) chart.lines.push_back(std::move(c.line));
    }
    const auto best = std::min_element(all.begin(), all.end(), [](const Compared& a, const Compared& b) {
        return a.wrong_stable + a.wrong_unstable < b.wrong_stable + b.wrong_unstable;
    });
    const std::string finding = "Of the reductions, " + best->model + " judges this chart best: wrongly on " +
                                percent(best->wrong_stable + best->wrong_unstable) + " of it.";
    return line_figure(chart_id("reductions", slice.x, slice.y), std::move(chart), finding,
                       "Solid: the full joint, with memory. Dashed: what each reduction of Figs. 4 to 7 makes of it, "
                       "every place reduced anew. Where the curves part, the assumption breaks." +
                           errors + " Shares are of the chart's area, from verdicts on " +
                           std::to_string(x.values.size()) + " × " + std::to_string(y.values.size()) + " places.");
}

}  // namespace stickslip
