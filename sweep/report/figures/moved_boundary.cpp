#include "sweep/report/figures/moved_boundary.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/words/interval_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

std::string gain_text(const StableWindows& w, Units units)
{
    if (!w.refused.empty()) return "no verdict: " + w.refused;
    if (!w.known()) return "no verdict: no steady sliding at this velocity";
    return w.k_p.empty() ? "none" : intervals_text(w.k_p, Quantity::position_gain, units);
}

const char* motion_word(const StableWindows& w)
{
    return w.stable ? "slides" : "sticks and slips";
}

constexpr double same = 1e-9, hardly = 1e-3;  // relative changes: rounding, and less than a chart shows

bool close(double x, double y, double within)
{
    return x == y || std::abs(x / y - 1) < within;
}

bool alike(const std::vector<Interval>& a, const std::vector<Interval>& b, double within)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Interval& x, const Interval& y) {
        return close(x.low, y.low, within) && close(x.high, y.high, within);
    });
}

/// Over all velocities, a missing end included.
bool alike(const std::vector<double>& a, const std::vector<double>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return close(x, y, hardly) || (!std::isfinite(x) && !std::isfinite(y));
    });
}

Table windows_table(const WindowsOfBoth& at, double velocity, Units units, const std::string& with)
{
    Table table{"At V_{0} = " + with_unit(velocity, Quantity::velocity, units), {"", "nominal joint", with}, {}};
    table.rows.push_back({"stable position gains k_{p}", gain_text(at.before, units), gain_text(at.after, units)});
    const auto row = [&](const char* name, auto number) {
        table.rows.push_back({name, at.before.known() ? number(at.before) : std::string("–"),
                              at.after.known() ? number(at.after) : std::string("–")});
    };
    row("least velocity gain by velocity-only theory",
        [&](const StableWindows& w) { return with_unit(w.k_v_min, Quantity::velocity_gain, units); });
    row("slowest decay (+: growth)",
        [&](const StableWindows& w) { return with_unit(w.spectral_abscissa, Quantity::rate, units); });
    row("with the joint's own gains", [](const StableWindows& w) { return std::string(motion_word(w)); });
    return table;
}

std::string moved_sentence(const MovedBoundary& moved, Units units, const std::string& with)
{
    const auto& [before, after] = moved.at;
    if (!before.known() || !after.known())
        return "The linear theory has no verdict for " +
               std::string(before.known() ? "the joint " + with : "the nominal joint") + ".";
    if (alike(before.k_p, after.k_p, same))
        return "The cause does not act in this theory: the stable gains are unchanged, " + gain_text(before, units) +
               ".";
    if (alike(before.k_p, after.k_p, hardly))
        return "The stable gains change by less than " + percent(hardly) + ": " + gain_text(before, units) + ".";
    return "The stable position gains are " + gain_text(before, units) + " in the nominal joint and " +
           gain_text(after, units) + " " + with + "; the joint's own, " +
           with_unit(moved.own_gain, Quantity::position_gain, units) + ", " + motion_word(after) + " " + with + ".";
}

std::vector<LineChart::Line> ends(const MovedBoundary& moved, const std::string& with)
{
    std::vector<LineChart::Line> lines = {{"nominal joint", moved.speeds, moved.before.low, true},
                                          {"nominal joint, upper end", moved.speeds, moved.before.high, true},
                                          {with, moved.speeds, moved.after.low, false},
                                          {with + ", upper end", moved.speeds, moved.after.high, false}};
    std::erase_if(lines, [](const LineChart::Line& line) {
        return std::ranges::count_if(line.y, [](double y) { return std::isfinite(y); }) < 2;
    });
    return lines;
}

}  // namespace

Section moved_section(const MovedBoundary& moved, Units units, const std::string& with, const std::string& text)
{
    Section section{"boundary", "Effect on the stability map", "", {}, {}};
    if (!is_set(moved.velocity)) {
        section.text = "These data show no motion at whose velocity a boundary could be computed." + text;
        return section;
    }
    const auto sentence = moved_sentence(moved, units, with);
    section.text = sentence + text;
    section.tables.push_back(windows_table(moved.at, moved.velocity, units, with));
    auto lines = ends(moved, with);
    const bool moves = !alike(moved.before.low, moved.after.low) || !alike(moved.before.high, moved.after.high);
    if (lines.empty() || !moves) return section;
    LineChart chart;
    chart.title = "Boundary of the stable position gains";
    chart.x_label = axis_label(moved.velocity < 0 ? "commanded speed |V_{0}|, backwards" : "commanded velocity V_{0}",
                               Quantity::velocity, units);
    chart.y_label = axis_label("position gain k_{p}", Quantity::position_gain, units);
    chart.x_log = chart.y_log = true;
    chart.lines = std::move(lines);
    section.figures.push_back(
        line_figure("moved-boundary", std::move(chart), sentence,
                    "Gains within a window slide smoothly, gains outside stick and slip or oscillate; where a curve is "
                    "missing, the window has no such end. Gains in the units of the drive."));
    return section;
}

}  // namespace stickslip
