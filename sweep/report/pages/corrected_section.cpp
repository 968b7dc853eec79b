#include "sweep/report/pages/corrected_section.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/figures/thinned_line.h"
#include "sweep/words/gains_text.h"
#include "sweep/words/least_velocity_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

Table gains_table(const CorrectedGains& g, Units units)
{
    Table table{"Gains and what they give", {"gains", "k_{p}", "k_{v}", "margin", "stable down to"}, {}};
    const double lowest = lowest_velocity_searched(g.required, std::abs(g.velocity));
    const auto add = [&](const char* name, const GainChoice& c) {
        const bool stable = !(c.margin < 0);
        table.rows.push_back(
            {name, with_unit(c.k_p / g.per_drive, Quantity::position_gain, units),
             with_unit(c.k_v / g.per_drive, Quantity::velocity_gain, units),
             stable ? (c.margin >= g.right->margin_reach ? "> " : "") + plain_number(c.margin, 3) : "unstable",
             stable ? least_velocity_text(c.least_velocity, lowest, units) : "–"});
    };
    add(g.right->feasible ? "recommended" : "nearest to feasible", g.right->best);
    add("as in the joint", g.right->as_joint);
    return table;
}

/// A second picture of the same would show nothing.
bool looks_alike(const Slice& a, const Slice& b)
{
    constexpr double visible = 0.01;  // of the largest rate
    double largest = 0;
    for (const double s : a.abscissa)
        if (std::isfinite(s)) largest = std::max(largest, std::abs(s));
    return a.region == b.region && std::ranges::equal(a.abscissa, b.abscissa, [&](double s, double t) {
               return std::abs(s - t) <= visible * largest || (!std::isfinite(s) && !std::isfinite(t));
           });
}

Figure chart_figure(const GainChart& chart, const CorrectedGains& g, Units units, const char* id,
                    const std::string& joint, const char* cross)
{
    Figure figure = map_figure(units, chart.slice, chart.answer);
    auto& map = std::get<StabilityMap>(figure.picture);
    figure.id = id;
    map.title = "The " + joint;
    map.fixed = "V_{0} = " + with_unit(g.velocity, Quantity::velocity, units);
    figure.finding = "The " + joint + ". " + figure.finding;
    figure.caption = "The " + joint + "; the cross is " + cross + " gains. " + figure.caption;
    if (g.per_drive != 1)
        figure.caption +=
            " Gains here are counted at the joint, " + plain_number(g.per_drive, 4) + " times those of the drive.";
    return figure;
}

Figure motion_figure(const CorrectedGains& g, Units units, const std::string& with)
{
    LineChart chart;
    chart.title = "How both joints move at V_{0} = " + with_unit(g.velocity, Quantity::velocity, units);
    chart.x_label = axis_label("time t", Quantity::time, units);
    chart.y_label = axis_label("velocity V", Quantity::velocity, units);
    chart.lines.push_back(thinned({"nominal joint", g.motion_before.time, g.motion_before.velocity, true}));
    chart.lines.push_back(thinned({with, g.motion_after.time, g.motion_after.velocity}));
    std::erase_if(chart.lines, [](const LineChart::Line& line) { return line.x.empty(); });
    return line_figure("motion-corrected", std::move(chart),
                       "Velocity of the nominal joint " + settled_text(g.settled_before, units) + ", and " + with +
                           " " + settled_text(g.settled_after, units) + ", in the last third of each motion.",
                       "Simulated from steady sliding and a small disturbance, with every term of the file, those that "
                       "depend on position and time among them; one motion is one example.");
}

}  // namespace

void add_corrected_gains(Section& section, const CorrectedGains& g, Units units, const std::string& with)
{
    if (!is_set(g.velocity)) return;
    section.text += " " + right_gains_text(g, units, with);
    section.tables.push_back(
        {"Velocity in the last third of a simulated motion, from steady sliding on",
         {"joint", "velocity"},
         {{"nominal", settled_text(g.settled_before, units)}, {with, settled_text(g.settled_after, units)}}});
    if (g.right && g.right->decided) section.tables.push_back(gains_table(g, units));
    const bool changed = !(g.before && g.after && looks_alike(g.before->slice, g.after->slice));
    if (g.before)
        section.figures.push_back(chart_figure(*g.before, g, units, "map-nominal", "nominal joint", "the joint's own"));
    if (!changed) section.figures.back().caption += " The map of the joint " + with + " looks the same.";
    if (g.after && changed)
        section.figures.push_back(
            chart_figure(*g.after, g, units, "map-corrected", "joint " + with, "the joint's own"));
    if (g.after && g.right && g.right->feasible) {
        auto chart = *g.after;
        chart.answer.design = g.at_right;
        section.figures.push_back(chart_figure(chart, g, units, "map-right",
                                               "joint " + with + " and the recommended gains", "the recommended"));
    }
    if (!g.motion_before.time.empty() || !g.motion_after.time.empty())
        section.figures.push_back(motion_figure(g, units, with));
}

}  // namespace stickslip
