#include "sweep/report/pages/record_report.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/words/heading_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

std::vector<double> error_of(const FollowedReference& r)
{
    std::vector<double> error;
    for (std::size_t k = 0; k < std::min(r.reference_position.size(), r.position.size()); ++k)
        error.push_back(r.reference_position[k] - r.position[k]);
    return error;
}

double largest(const std::vector<double>& values)
{
    double size = 0;
    for (const double v : values)
        if (std::isfinite(v)) size = std::max(size, std::abs(v));
    return size;
}

Figure position_figure(const FollowedReference& r, const std::vector<double>& error, Units units)
{
    DetailedChart chart;
    chart.title = "Reference and position";
    chart.x_label = axis_label("time t", Quantity::time, units);
    chart.y_label = axis_label("position", Quantity::position, units);
    chart.lines = {{"position", r.time, r.position}, {"reference", r.time, r.reference_position, true}};
    chart.lines[0].wide = true;
    chart.below_label = axis_label("reference minus position", Quantity::position, units);
    chart.below = {{"tracking error", r.time, error}};
    return line_figure("reference", std::move(chart),
                       "The largest tracking error is " + with_unit(largest(error), Quantity::position, units) + ".",
                       "Position as the encoder reads it; below, how far it lies behind the reference.");
}

/// What the controller commands, as the effort that the documented drive makes of it; a motor's voltage or current
/// stays what it is.
std::vector<double> commanded_effort(const FollowedReference& r, const Actuator& actuator)
{
    auto command = r.effort_command;
    if (actuator.kind == ActuatorKind::effort)
        for (double& u : command) u *= actuator.effort_gain;
    return command;
}

Figure effort_figure(const FollowedReference& r, const Joint& joint)
{
    const Units units = units_of(joint);
    const bool effort = joint.actuator.kind == ActuatorKind::effort;
    const auto command = commanded_effort(r, joint.actuator);
    DetailedChart chart;
    chart.title = "Effort";
    chart.x_label = axis_label("time t", Quantity::time, units);
    chart.y_label =
        effort ? axis_label("effort", Quantity::effort, units) : AxisName{"command", "unit of the drive signal"};
    chart.lines = {{"command", r.time, command, true}};
    if (!effort) {
        chart.title = "Command and effort";
        chart.below_label = axis_label("effort", Quantity::effort, units);
        if (!r.effort_measured.empty()) chart.below = {{"measured", r.time, r.effort_measured}};
        return line_figure(
            "effort", std::move(chart), "The command reaches " + plain_number(largest(command)) + ".",
            "What the controller sends to the motor, in the unit of its drive signal; below, what the drive "
            "reports.");
    }
    if (!r.effort_measured.empty()) {  // broad, so that the command is seen on it
        chart.lines.insert(chart.lines.begin(), {"measured", r.time, r.effort_measured});
        chart.lines.front().wide = true;
    }
    return line_figure(
        "effort", std::move(chart), "The command reaches " + with_unit(largest(command), Quantity::effort, units) + ".",
        "What the controller commands, times the effort per unit of the drive signal, and what the drive "
        "reports.");
}

}  // namespace

Report record_report(const Joint& joint, const FollowedReference& r)
{
    const Units units = units_of(joint);
    const auto error = error_of(r);
    Report report;
    report.title = "The joint along a reference";
    report.subtitle = gains_text(joint);
    report.verdict = "The position stays within " + with_unit(largest(error), Quantity::position, units) +
                     " of the reference over " + with_unit(r.time.back(), Quantity::time, units) + ".";
    if (!r.loop.empty()) report.alerts.push_back({Headline::Tone::bad, r.loop});
    if (!r.ends_early.empty())
        report.alerts.push_back({Headline::Tone::warning, "The simulation ends early: " + r.ends_early + "."});
    Section section{"motion", "Motion", "", {position_figure(r, error, units)}, {}};
    if (!r.effort_command.empty()) section.figures.push_back(effort_figure(r, joint));
    report.sections.push_back(std::move(section));
    report.not_checked = {"Other references, loads and noise: one motion is one example."};
    return report;
}

}  // namespace stickslip
