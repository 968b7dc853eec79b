#include "sweep/report/pages/corrected_section.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/figures/thinned_line.h"
#include "sweep/words/reason_text.h"
#include "sweep/words/verdict_text.h"

#include <cmath>

namespace stickslip {
namespace {

std::string gains_words(double k_p, double k_v, const CorrectedGains& g, Units units)
{
    return "k_{p} = " + with_unit(k_p / g.per_drive, Quantity::position_gain, units) +
           ", k_{v} = " + with_unit(k_v / g.per_drive, Quantity::velocity_gain, units);
}

/// Under which assumptions the right gains are right.
std::string premises(const CorrectedGains& g, Units units)
{
    std::string text = "least noise of the link at a margin of " + plain_number(g.required.margin);
    if (is_set(g.required.k_p_low))
        text +=
            " with a k_{p} of at least " + with_unit(g.required.k_p_low / g.per_drive, Quantity::position_gain, units);
    if (std::isfinite(g.required.effort_limit))
        text += " within " + with_unit(g.required.effort_limit, Quantity::effort, units);
    if (!g.noise_is_stated)
        text += "; the joint file states no noise of its position, which scales that of the link alone";
    if (!g.rate_is_stated)
        text +=
            "; it states no period, and " + with_unit(g.required.noise.period, Quantity::time, units) + " was taken";
    return text;
}

std::string no_gains_words(const CorrectedGains& g)
{
    switch (g.none) {
        case NoGains::force_control:
            return "the motor is a source of force, whose loop has no gains to choose";
        case NoGains::dead_time:
            return "behind dead time without a period each pair of gains takes a search for roots; stickslip design "
                   "corrected-joint.toml does it";
        case NoGains::interrupted:
            return "the search was interrupted; stickslip design corrected-joint.toml does it";
        case NoGains::looked_for:
        case NoGains::refused:
            break;
    }
    return g.refusal;
}

std::string right_gains_words(const CorrectedGains& g, Units units, const std::string& with)
{
    if (g.none != NoGains::looked_for) return " No gains were looked for: " + no_gains_words(g) + ".";
    if (!g.right || !g.right->decided)
        return " No gains can be right: the joint " + with + " has no steady sliding here.";
    const auto& best = g.right->best;
    const std::string gains = gains_words(best.k_p, best.k_v, g, units);
    if (!g.right->feasible)
        return " No gains meet all requirements in the joint " + with + "; nearest to it are " + gains + " (" +
               premises(g, units) + ").";
    return " Right for the joint " + with + " would be " + gains + " (" + premises(g, units) +
           "). stickslip design corrected-joint.toml answers other requirements.";
}

Table gains_table(const CorrectedGains& g, Units units)
{
    Table table{"Gains and what they give", {"gains", "k_{p}", "k_{v}", "margin", "stable down to"}, {}};
    const auto add = [&](const char* name, const GainChoice& c) {
        const bool stable = !(c.margin < 0);
        table.rows.push_back(
            {name, with_unit(c.k_p / g.per_drive, Quantity::position_gain, units),
             with_unit(c.k_v / g.per_drive, Quantity::velocity_gain, units),
             stable ? (c.margin >= g.right->margin_reach ? "> " : "") + plain_number(c.margin, 3) : "unstable",
             stable && std::isfinite(c.least_velocity) ? with_unit(c.least_velocity, Quantity::velocity, units) : "–"});
    };
    add(g.right->feasible ? "right" : "nearest to feasible", g.right->best);
    add("as in the joint", g.right->as_joint);
    return table;
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

/// "between 0 m/s and 3 mm/s, at rest for 40 % of it"; the last third of a motion.
std::string settled_words(const Trajectory& motion, Units units)
{
    if (motion.time.empty()) return "not simulated: " + reason_text(motion.reason);
    const double from = 2 * motion.time.back() / 3;
    double low = infinity, high = -infinity, rest = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
        if (motion.time[i] < from) continue;
        low = std::min(low, motion.velocity[i]), high = std::max(high, motion.velocity[i]);
        if (motion.stuck[i] && i + 1 < motion.time.size()) rest += motion.time[i + 1] - motion.time[i];
    }
    const double share = rest / (motion.time.back() - from);
    return span_text(low, high, Quantity::velocity, units) +
           (share > 0 ? ", at rest for " + percent(share) + " of it" : "");
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
                       "Velocity of the nominal joint " + settled_words(g.motion_before, units) + ", and " + with +
                           " " + settled_words(g.motion_after, units) + ", in the last third of each motion.",
                       "Simulated from steady sliding and a small disturbance, with every term of the file, those that "
                       "depend on position and time among them; one motion is one example.");
}

}  // namespace

void add_corrected_gains(Section& section, const CorrectedGains& g, Units units, const std::string& with)
{
    if (!is_set(g.velocity)) return;
    section.text += right_gains_words(g, units, with);
    section.tables.push_back(
        {"Velocity in the last third of a simulated motion, from steady sliding on",
         {"joint", "velocity"},
         {{"nominal", settled_words(g.motion_before, units)}, {with, settled_words(g.motion_after, units)}}});
    if (g.right && g.right->decided) section.tables.push_back(gains_table(g, units));
    if (g.before)
        section.figures.push_back(chart_figure(*g.before, g, units, "map-nominal", "nominal joint", "the joint's own"));
    if (g.after)
        section.figures.push_back(
            chart_figure(*g.after, g, units, "map-corrected", "joint " + with, "the joint's own"));
    if (g.after && g.right && g.right->feasible) {
        auto chart = *g.after;
        chart.answer.design = g.at_right;
        section.figures.push_back(
            chart_figure(chart, g, units, "map-right", "joint " + with + " and its right gains", "the right"));
    }
    if (!g.motion_before.time.empty() || !g.motion_after.time.empty())
        section.figures.push_back(motion_figure(g, units, with));
}

}  // namespace stickslip
