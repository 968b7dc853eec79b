#include "sweep/report/pages/comparison_section.h"

#include "sweep/report/figures/line_figure.h"
#include "sweep/report/figures/vmin_figure.h"
#include "sweep/report/pages/gain_words.h"
#include "sweep/words/interval_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// The least k_v at the joint's own k_p over its searched velocities, by both theories.
Figure demand_figure(const Joint& joint, const LinearDetails& d)
{
    const GainWords words{units_of(joint)};
    LineChart chart;
    chart.title = "Velocity gain that each theory requires";
    chart.fixed = "k_{p} = " + words.stiffness(joint.control.k_p);
    chart.x_label = axis_label(d.velocity < 0 ? "commanded speed |V_{0}|, backwards" : "commanded velocity V_{0}",
                               Quantity::velocity, words.units);
    chart.y_label = axis_label("least k_{v}", Quantity::velocity_gain, words.units);
    chart.x_log = true;
    // demands span decades; none, which is zero, lies on the lower edge
    for (const auto* line : {&d.demanded_memory, &d.demanded_simple})
        chart.y_log = chart.y_log || std::any_of(line->y.begin(), line->y.end(), [](double y) { return y > 0; });
    chart.lines = {{"with memory", d.demanded_memory.x, d.demanded_memory.y},
                   {"velocity-only model", d.demanded_simple.x, d.demanded_simple.y, true}};
    chart.x_marks.emplace_back("here", std::abs(d.velocity));
    const auto& here = d.study.comparison;
    return line_figure(
        "k-v-demanded", std::move(chart),
        "At the joint's own velocity, the velocity-only model requires: " +
            required_text(here.k_v_velocity_only, words.units) +
            "; with memory: " + required_text(here.k_v_memory, words.units) + ".",
        "Least velocity gain for stable sliding at the joint's own position gain, over the velocity. For a Stribeck "
        "curve the required gain falls as velocity goes to zero, for the logarithmic curve of state-variable friction "
        "it "
        "grows as 1/V_{0}. On the lower edge none is needed; in a gap none is enough.");
}

/// The least velocity gain among those of the figure of V_min with which every velocity was found stable.
std::string enough_words(const LinearDetails& details, const GainWords& words)
{
    double least = infinity;
    std::string tried;
    for (const auto& line : details.least_velocities) {
        if (line.here == searched_speeds(details.study).low) least = std::min(least, line.k_v);
        tried += (tried.empty() ? "" : ", ") + words.damping(line.k_v);
    }
    if (least < infinity) return "k_{v} = " + words.damping(least) + " is enough";
    return tried.empty() ? "–" : "not searched; not enough: " + tried;
}

Table comparison_table(const Joint& joint, const LinearDetails& details)
{
    const auto& study = details.study;
    const GainWords words{units_of(joint)};
    const auto& c = study.comparison;
    Table table;
    table.title = "What each theory requires of this joint";
    table.columns = {"", "velocity-only model", "with memory"};
    if (c.known)
        table.rows = {{"velocity gain required at this k_{p}", required_text(c.k_v_velocity_only, words.units),
                       required_text(c.k_v_memory, words.units)},
                      {"stable k_{v} at this k_{p}", words.gains(c.k_v_velocity_only, Quantity::velocity_gain),
                       words.gains(c.k_v_memory, Quantity::velocity_gain)},
                      {"stable k_{p} at this k_{v}", words.gains(c.k_p_velocity_only, Quantity::position_gain),
                       words.gains(c.k_p_memory, Quantity::position_gain)},
                      {"k_{p} stable in this theory only",
                       words.gains(words.differing(c.allowed_wrongly), Quantity::position_gain),
                       words.gains(words.differing(c.forbidden_needlessly), Quantity::position_gain)}};
    if (!std::isnan(study.velocities.low)) {
        // at the end of the search, slower ones may be smooth as well
        const auto least = [&, low = searched_speeds(study).low](double velocity) {
            return (velocity == low ? "≤ " : "") + words.velocity(velocity);
        };
        table.rows.push_back(
            {"slowest smooth velocity", least(study.velocity_only.least), least(study.state_variable.least)});
        table.rows.push_back({"V_{min}: every faster velocity slides smoothly", least(study.velocity_only.all_above),
                              least(study.state_variable.all_above)});
    }
    if (!std::isnan(study.velocity_only.least_force_rate) || !std::isnan(study.state_variable.least_force_rate))
        table.rows.push_back({"least stable rate of force",
                              with_unit(study.velocity_only.least_force_rate, Quantity::effort_rate, words.units, 4),
                              with_unit(study.state_variable.least_force_rate, Quantity::effort_rate, words.units, 4)});
    if (study.range_gain)
        table.rows.push_back(
            {"k_{v} for every velocity up to " +
                 words.velocity(study.velocities.high > 0 ? study.velocities.high : study.velocities.low),
             required_text(study.range_gain->stable_k_v, words.units) +
                 " (hardest: " + words.velocity(study.range_gain->velocity) + ")",
             enough_words(details, words)});
    if (!std::isnan(study.mix.noise))
        table.rows.push_back(
            {"quietest pair of gains on the boundary (velocity differenced from position)", "–",
             "k_{p} = " + words.stiffness(study.mix.k_p) + ", k_{v} = " + words.damping(study.mix.k_v)});
    return table;
}

std::string comparison_words(const Comparison& c, const GainWords& words)
{
    std::string text =
        "The velocity-only model is stable where k_{v} outweighs the falling steady curve, (21); with memory, sliding "
        "is also stable where a stiff position loop moves the slip faster than the memory responds, (34)-(37).";
    if (const auto differ = words.differing(c.forbidden_needlessly); !differ.empty())
        text += " Here the velocity-only model predicts stick-slip for k_{p} " +
                words.gains(differ, Quantity::position_gain) +
                " although sliding is stable with memory, as Armstrong observed with his stiffest springs (§5).";
    if (const auto differ = words.differing(c.allowed_wrongly); !differ.empty())
        text += " Here the velocity-only model predicts stability for k_{p} " +
                words.gains(differ, Quantity::position_gain) +
                " although sliding is unstable there: for one mass this takes a lag or a negative direct effect, for "
                "several masses the springs between them suffice.";
    return text +
           " On the unstable side, more stiffness or damping first makes stick-slip smaller before it ends it "
           "(Rabinowicz, §5): amplitudes are a matter of the nonlinear joint, and of its maps.";
}

/// Whether anything is required: a chart of zeros shows nothing.
bool demands_any(const Samples& demand)
{
    return std::any_of(demand.y.begin(), demand.y.end(), [](double k_v) { return k_v > 0 || std::isnan(k_v); });
}

/// Whether every line lies at one value.
bool stands_at(const LineChart& chart, double value)
{
    const auto same = [&](const LineChart::Line& line) {
        return std::all_of(line.y.begin(), line.y.end(), [&](double y) { return y == value; });
    };
    return !chart.lines.empty() && std::all_of(chart.lines.begin(), chart.lines.end(), same);
}

std::string stable_everywhere_text(const LineChart& chart, const Interval& velocities, const GainWords& words)
{
    std::string gains;
    for (const auto& line : chart.lines) gains += (gains.empty() ? "" : ", ") + line.name;
    const auto& k_p = chart.lines.front().x;
    return "With memory, every velocity " +
           range_text(velocities.low, velocities.high, Quantity::velocity, words.units) +
           " slides smoothly, for k_{p} " +
           range_text(k_p.front(), k_p.back(), Quantity::position_gain, words.units, from_to, 4) + " and " + gains +
           ".";
}

}  // namespace

Section comparison_section(const Joint& joint, const LinearDetails& details)
{
    const auto& study = details.study;
    const GainWords words{units_of(joint)};
    Section section{"comparison", "Velocity-only model and memory", comparison_words(study.comparison, words), {}, {}};
    if (!study.comparison.known) section.text += " This loop has no independent gains k_{p} and k_{v}.";
    if (!std::isnan(study.velocities.low)) {
        if (study.comparison.known && (demands_any(details.demanded_memory) || demands_any(details.demanded_simple)))
            section.figures.push_back(demand_figure(joint, details));
        else if (study.comparison.known)
            section.text +=
                " At its own k_{p}, neither theory requires any k_{v} of this joint at any velocity searched.";
        auto slowest = vmin_figure(joint, details);
        const auto& chart = std::get<LineChart>(slowest.picture);
        if (stands_at(chart, searched_speeds(study).low))
            section.text += " " + stable_everywhere_text(chart, study.velocities, words);
        else if (!chart.lines.empty())
            section.figures.push_back(std::move(slowest));
    }
    section.tables.push_back(comparison_table(joint, details));
    return section;
}

}  // namespace stickslip
