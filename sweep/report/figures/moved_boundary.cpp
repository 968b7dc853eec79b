#include "sweep/report/figures/moved_boundary.h"

#include "analysis/results/text.h"
#include "analysis/stability/verdict.h"
#include "sweep/words/line_figure.h"

#include <cmath>
#include <exception>

namespace stickslip {
namespace {

struct Guarded {
    LinearVerdict verdict;
    std::string reason;  ///< why there is none
    bool known() const { return reason.empty(); }
};

Guarded verdict_at(Joint joint, double velocity)
{
    joint.control.V0 = velocity;
    joint.control.force_rate = not_set;
    Guarded g;
    try {
        g.verdict = linear_verdict(joint);
        const auto& v = g.verdict.state_variable;
        if (std::isnan(v.spectral_abscissa)) g.reason = "no steady sliding at this velocity";
    } catch (const std::exception& e) {
        g.reason = e.what();
    }
    return g;
}

/// What small disturbances do where no gain is critical.
std::string always_text(const Guarded& g)
{
    return g.verdict.state_variable.stable ? "small disturbances always decay" : "they always grow";
}

std::string gain_text(const Guarded& g, Motion motion)
{
    if (!g.known()) return "no verdict: " + g.reason;
    const auto& v = g.verdict.state_variable;
    return std::isfinite(v.k_cr) ? with_unit(v.k_cr, Quantity::stiffness, motion) : "none: " + always_text(g);
}

LineChart::Line critical_gains(const Joint& joint, const std::vector<double>& velocities, std::string name, bool dashed)
{
    LineChart::Line line{std::move(name), {}, {}, dashed};
    for (const double V : velocities) {
        const auto g = verdict_at(joint, V);
        const double k = g.known() ? g.verdict.state_variable.k_cr : not_set;
        line.x.push_back(V), line.y.push_back(std::isfinite(k) && k > 0 ? k : not_set);
    }
    return line;
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
    const Motion motion = before.mechanism.motion;
    MovedBoundary moved;
    if (!(speed > 0) || !std::isfinite(speed)) {
        moved.sentence = "These data show no motion at whose velocity a boundary could be asked for.";
        return moved;
    }
    const auto one = verdict_at(before, speed), two = verdict_at(after, speed);
    moved.table = {"At V_{0} = " + with_unit(speed, Quantity::velocity, motion), {"", "nominal joint", with}, {}};
    moved.table.rows.push_back({"critical position gain k_{cr}", gain_text(one, motion), gain_text(two, motion)});
    const auto row = [&](const char* name, auto number) {
        moved.table.rows.push_back({name, one.known() ? number(one.verdict) : std::string("–"),
                                    two.known() ? number(two.verdict) : std::string("–")});
    };
    row("least velocity gain by velocity-only theory",
        [&](const LinearVerdict& v) { return with_unit(v.velocity_only.k_v_min, Quantity::damping, motion); });
    row("slowest decay (+: growth)",
        [&](const LinearVerdict& v) { return with_unit(v.state_variable.spectral_abscissa, Quantity::rate, motion); });
    row("with the joint's own gains",
        [](const LinearVerdict& v) { return std::string(v.state_variable.stable ? "slides" : "sticks and slips"); });

    const auto velocities = log_steps(0.01 * speed, 2 * speed, 41);
    auto nominal = critical_gains(before, velocities, "nominal joint", true);
    auto cause = critical_gains(after, velocities, with, false);
    const bool drawn = any(nominal) || any(cause);
    const double k = one.known() ? one.verdict.state_variable.k_cr : not_set;
    const double k_after = two.known() ? two.verdict.state_variable.k_cr : not_set;
    if (!one.known() || !two.known())
        moved.sentence = "The linear theory has no verdict for " +
                         std::string(one.known() ? "the joint " + with : "the nominal joint") + ".";
    else if (std::isfinite(k) && std::isfinite(k_after))
        moved.sentence = std::abs(k_after / k - 1) < 1e-9
                             ? "The cause does not act in this theory: the critical gain stays where it was."
                             : "The critical position gain moves from " + with_unit(k, Quantity::stiffness, motion) +
                                   " to " + with_unit(k_after, Quantity::stiffness, motion) + ".";
    else if (std::isfinite(k_after))
        moved.sentence = "The nominal joint has no critical gain; " + with + " it has one, " +
                         with_unit(k_after, Quantity::stiffness, motion) + ".";
    else if (std::isfinite(k))
        moved.sentence = "The critical gain of the nominal joint, " + with_unit(k, Quantity::stiffness, motion) +
                         ", is no longer one " + with + ": " + always_text(two) + ".";
    else
        moved.sentence = "No position gain is critical at this velocity, neither before nor after.";
    if (!drawn) return moved;
    LineChart chart;
    chart.title = "The boundary moves";
    chart.x_label = axis_label("commanded velocity V_{0}", Quantity::velocity, motion);
    chart.y_label = axis_label("critical position gain k_{cr}", Quantity::stiffness, motion);
    chart.x_log = chart.y_log = true;
    for (auto* line : {&nominal, &cause})
        if (any(*line)) chart.lines.push_back({line->name, line->x, line->y, line->dashed});
    moved.figures.push_back(line_figure("moved-boundary", std::move(chart), moved.sentence,
                                        "Gains on one side of a curve slide, on the other they stick and slip; where a "
                                        "curve is missing, no gain is critical."));
    return moved;
}

}  // namespace stickslip
