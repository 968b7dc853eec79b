#include "sweep/report/figures/moved_boundary.h"

#include "analysis/joint/gains.h"
#include "analysis/joint/loop_side.h"
#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/words/line_figure.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace stickslip {
namespace {

struct Guarded {
    LinearVerdict verdict;
    std::vector<Interval> gains;  ///< stable k_p as the drive counts it
    std::string reason;           ///< why there is none
    bool known() const { return reason.empty(); }
};

Guarded verdict_at(const Joint& joint, double velocity)
{
    const Joint summed = with_gains(joint);  // a cascade has k_p only as part of its sum of gains
    Joint there = with_loop_at_joint(summed);
    there.control.V0 = velocity;
    there.control.force_rate = not_set;
    Guarded g;
    try {
        g.verdict = linear_verdict(there);
        const auto& v = g.verdict.state_variable;
        if (std::isnan(v.spectral_abscissa)) g.reason = "no steady sliding at this velocity";
        const double unit = there.control.k_p / summed.control.k_p;
        for (const auto& i : v.stable_intervals) g.gains.push_back({i.low / unit, i.high / unit});
    } catch (const std::exception& e) {
        g.reason = e.what();
    }
    return g;
}

std::string gain_text(const Guarded& g, Units units)
{
    if (!g.known()) return "no verdict: " + g.reason;
    return g.gains.empty() ? "none" : intervals_text(g.gains, Quantity::position_gain, units);
}

/// Both ends of the window that holds the joint's own gain, or else of the first.
struct Window {
    LineChart::Line low, high;
};

Window windows(const Joint& joint, const std::vector<double>& velocities, const std::string& name, bool dashed)
{
    const double own_gain = gains_of(joint.control).k_p;
    Window window{{name, {}, {}, dashed}, {name + ", upper end", {}, {}, dashed}};
    for (const double V : velocities) {
        const auto g = verdict_at(joint, V);
        const auto own = std::find_if(g.gains.begin(), g.gains.end(),
                                      [&](const Interval& i) { return i.low < own_gain && own_gain < i.high; });
        const auto shown = own != g.gains.end() ? own : g.gains.begin();
        const bool none = !g.known() || g.gains.empty();
        window.low.x.push_back(V), window.high.x.push_back(V);
        window.low.y.push_back(none || !(shown->low > 0) ? missing : shown->low);
        window.high.y.push_back(none || !std::isfinite(shown->high) ? missing : shown->high);
    }
    return window;
}

bool any(const LineChart::Line& line)
{
    int finite = 0;
    for (double y : line.y) finite += std::isfinite(y);
    return finite >= 2;
}

}  // namespace

MovedBoundary moved_boundary(const Joint& before, const Joint& after, double speed, const std::string& with)
{
    const Units units = units_of(before);
    MovedBoundary moved;
    if (!(speed > 0) || !std::isfinite(speed)) {
        moved.sentence = "These data show no motion at whose velocity a boundary could be computed.";
        return moved;
    }
    const auto one = verdict_at(before, speed), two = verdict_at(after, speed);
    moved.table = {"At V_{0} = " + with_unit(speed, Quantity::velocity, units), {"", "nominal joint", with}, {}};
    moved.table.rows.push_back({"stable position gains k_{p}", gain_text(one, units), gain_text(two, units)});
    const auto row = [&](const char* name, auto number) {
        moved.table.rows.push_back({name, one.known() ? number(one.verdict) : std::string("–"),
                                    two.known() ? number(two.verdict) : std::string("–")});
    };
    row("least velocity gain by velocity-only theory",
        [&](const LinearVerdict& v) { return with_unit(v.velocity_only.k_v_min, Quantity::velocity_gain, units); });
    row("slowest decay (+: growth)",
        [&](const LinearVerdict& v) { return with_unit(v.state_variable.spectral_abscissa, Quantity::rate, units); });
    row("with the joint's own gains",
        [](const LinearVerdict& v) { return std::string(v.state_variable.stable ? "slides" : "sticks and slips"); });

    const auto velocities = log_steps(0.01 * speed, 2 * speed, 41);
    const auto nominal = windows(before, velocities, "nominal joint", true);
    const auto cause = windows(after, velocities, with, false);
    const auto lines = {&nominal.low, &nominal.high, &cause.low, &cause.high};
    const bool drawn = std::any_of(lines.begin(), lines.end(), [](const auto* line) { return any(*line); });
    const auto alike = [&] {
        constexpr double same = 1e-9;
        const auto close = [](double a, double b) { return a == b || std::abs(a / b - 1) < same; };
        return std::equal(
            one.gains.begin(), one.gains.end(), two.gains.begin(), two.gains.end(),
            [&](const Interval& a, const Interval& b) { return close(a.low, b.low) && close(a.high, b.high); });
    };
    if (!one.known() || !two.known())
        moved.sentence = "The linear theory has no verdict for " +
                         std::string(one.known() ? "the joint " + with : "the nominal joint") + ".";
    else if (alike())
        moved.sentence =
            "The cause does not act in this theory: the stable gains are unchanged, " + gain_text(one, units) + ".";
    else
        moved.sentence = "The stable position gains are " + gain_text(one, units) + " in the nominal joint and " +
                         gain_text(two, units) + " " + with + "; the joint's own, " +
                         with_unit(gains_of(before.control).k_p, Quantity::position_gain, units) + ", " +
                         (two.verdict.state_variable.stable ? "slides" : "sticks and slips") + " " + with + ".";
    if (!drawn) return moved;
    LineChart chart;
    chart.title = "The boundary moves";
    chart.x_label = axis_label("commanded velocity V_{0}", Quantity::velocity, units);
    chart.y_label = axis_label("position gain k_{p}", Quantity::position_gain, units);
    chart.x_log = chart.y_log = true;
    for (const auto* line : lines)
        if (any(*line)) chart.lines.push_back({line->name, line->x, line->y, line->dashed});
    moved.figures.push_back(
        line_figure("moved-boundary", std::move(chart), moved.sentence,
                    "Gains within a window slide smoothly, gains outside stick and slip or oscillate; where a curve is "
                    "missing, the window has no such end. Gains in the units of the drive."));
    return moved;
}

Section moved_section(MovedBoundary moved, const std::string& text)
{
    Section section{"boundary", "Effect on the stability map", moved.sentence + text, std::move(moved.figures), {}};
    if (!moved.table.rows.empty()) section.tables.push_back(std::move(moved.table));
    return section;
}

}  // namespace stickslip
