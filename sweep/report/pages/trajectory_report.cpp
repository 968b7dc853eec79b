#include "sweep/report/pages/trajectory_report.h"

#include "analysis/joint/commanded_velocity.h"
#include "analysis/results/text.h"
#include "analysis/stability/linear_joint.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/report/figures/thinned_line.h"
#include "sweep/words/ending_text.h"
#include "sweep/words/heading_text.h"
#include "sweep/words/low_limit_text.h"
#include "sweep/words/verdict_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// What a motion has settled to.
std::vector<double> settled(const MotionCurves& curves, const std::vector<double>& values)
{
    return {values.begin() + static_cast<std::ptrdiff_t>(curves.settled_from), values.end()};
}

/// "between −1 µm and 3 µm": what a chart's last line spans.
std::string range(const std::vector<double>& values, Quantity quantity, Units units)
{
    constexpr double resolved = 1e-12;  // of the largest: less is the rounding of a rest
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double least = resolved * std::max(std::abs(*low), std::abs(*high));
    const auto or_zero = [&](double value) { return std::abs(value) < least ? 0 : value; };
    return span_text(or_zero(*low), or_zero(*high), quantity, units);
}

/// The friction on the link, which the loop of friction over velocity shows.
const Friction& shown_friction(const Joint& joint)
{
    const Chain chain = chain_of(joint);
    return *chain.body[chain.bodies - 1].friction;
}

/// The velocity loop of what the motion has settled to, over the curve that friction without memory would follow.
std::vector<LineChart::Line> friction_loop(const Trajectory& t, const MotionCurves& curves)
{
    std::vector<LineChart::Line> lines{{"last third", settled(curves, t.velocity), settled(curves, t.friction)}};
    const auto& steady = curves.steady_friction;
    if (!steady.x.empty()) lines.push_back({"steady sliding f_{ss}(V)", steady.x, steady.y, true});
    return lines;
}

Figure line_figure(const char* id, LineChart chart, std::string caption, std::string finding)
{
    Figure figure;
    figure.id = id;
    figure.finding = chart.title + ". " + std::move(finding);
    figure.caption = std::move(caption);
    figure.picture = std::move(chart);
    return figure;
}

LineChart chart_of(const char* title, AxisName x_label, AxisName y_label, std::vector<LineChart::Line> lines)
{
    LineChart chart;
    chart.title = title;
    chart.x_label = std::move(x_label);
    chart.y_label = std::move(y_label);
    for (auto& line : lines) chart.lines.push_back(thinned(std::move(line)));
    return chart;
}

/// A quantity held over each sample, as a line.
LineChart::Line staircase(const char* name, double step, const std::vector<double>& values)
{
    LineChart::Line line{name, {}, {}};
    for (std::size_t i = 0; i < values.size(); ++i) {
        line.x.push_back(step * static_cast<double>(i)), line.y.push_back(values[i]);
        line.x.push_back(step * static_cast<double>(i + 1)), line.y.push_back(values[i]);
    }
    return line;
}

/// The linear answer as far as it stays near the motion: an unstable one would squeeze it into a line.
LineChart::Line linear_line(const ForcedResponse& linear, const Trajectory& t)
{
    double largest = 0;
    for (const double x : t.position) largest = std::max(largest, std::abs(x));
    LineChart::Line line{"linear theory", linear.time, linear.position, true};
    for (double& x : line.y)
        if (std::abs(x) > 3 * largest) x = missing;
    return line;
}

/// Reference and position themselves; the control force below where it is known.
Figure path_figure(const Trajectory& t, double slides_at, const std::vector<double>& force, Units units)
{
    std::vector<double> reference, position;
    for (std::size_t i = 0; i < t.time.size(); ++i) {
        reference.push_back(slides_at * t.time[i]);
        position.push_back(reference.back() + t.position[i]);
    }
    auto chart = detailed(
        chart_of("Position and reference in time", axis_label("time t", Quantity::time, units),
                 axis_label("position", Quantity::position, units),
                 {{"position", t.time, std::move(position)}, {"steady path", t.time, std::move(reference), true}}));
    std::string caption = "Position of the link, and the path of steady sliding at the commanded velocity.";
    if (!force.empty()) {
        chart.below_label = axis_label("control force u", Quantity::effort, units);
        auto below = thinned({"control force", t.time, force});
        chart.below = {{"control force", std::move(below.x), std::move(below.y)}};
        caption += " Below, the force of the loop: u = f_{ss}(V_{0}) − k_{p} x − k_{v} (V − V_{0}).";
    }
    Figure figure;
    figure.id = "path";
    figure.caption = std::move(caption);
    figure.finding = chart.title + ".";
    if (!force.empty()) figure.finding += " The control force stays " + range(force, Quantity::effort, units) + ".";
    figure.picture = std::move(chart);
    return figure;
}

Section surroundings_section(const SimulatedSurroundings& surroundings, const AxisName& time, Units units)
{
    Section section{"surroundings", "External forces", "", {}, {}};
    if (surroundings.linear && !surroundings.linear->force.value.empty()) {
        const auto& d = surroundings.linear->force;
        std::string caption =
            "d(t) of (9) on the link, held over each sample of " + with_unit(d.step, Quantity::time, units) + ".";
        if (d.impulse != 0)
            caption += " An impulse of " + with_unit(d.impulse, Quantity::impulse, units) + " precedes it.";
        section.figures.push_back(
            line_figure("force",
                        chart_of("Disturbing force in time", time, axis_label("force d", Quantity::effort, units),
                                 {staircase("d", d.step, d.value)}),
                        std::move(caption), "It stays " + range(d.value, Quantity::effort, units) + "."));
    }
    const auto& load = surroundings.normal_load;
    if (!load.value.empty())
        section.figures.push_back(line_figure(
            "normal-load",
            chart_of("Normal load in time", time, {"normal load σ_{n} per the nominal one"},
                     {staircase("σ_{n}", load.step, load.value)}),
            "σ_{n}(t) of (1) multiplies the friction of the link. The states of the law are those of the contacts and "
            "do not jump with it. Before the start the joint slides steadily under the first load.",
            "It stays " + range(load.value, Quantity::number, units) + "."));
    return section;
}

std::vector<std::string> not_checked(const NonlinearVerdict& verdict)
{
    std::vector<std::string> all{"Other and larger disturbances: one motion is one example."};
    if (verdict.path != DecisionPath::ticks)
        all.emplace_back("Sampling, saturation and quantisation of a digital loop.");
    return all;
}

}  // namespace

Report trajectory_report(const Joint& joint, const Trajectory& t, const NonlinearVerdict& verdict,
                         const SimulatedSurroundings& surroundings, const MotionCurves& curves)
{
    const Units units = units_of(joint);
    const auto time = axis_label("time t", Quantity::time, units),
               position = axis_label("excess position x", Quantity::position, units),
               velocity = axis_label("velocity V", Quantity::velocity, units),
               friction = axis_label("friction f", Quantity::effort, units);
    Report report;
    report.title = "One motion of the joint";
    report.subtitle = std::string(info(shown_friction(joint).law).name) +
                      " friction · V_{0} = " + with_unit(t.commanded_velocity, Quantity::velocity, units) + " · " +
                      gains_text(joint);
    if (t.time.empty()) {
        report.verdict = no_motion_text(joint, t);
        report.tone = Headline::Tone::warning;
        return report;
    }
    const bool forced = surroundings.linear || !surroundings.normal_load.value.empty();
    const auto last_third = range(settled(curves, t.velocity), Quantity::velocity, units);
    report.verdict = (forced ? "" : ending_text(verdict) + " ") + "In the last third of " +
                     with_unit(t.time.back(), Quantity::time, units) + " the velocity stays " + last_third + ".";
    if (!forced) {
        report.tone = ending_tone(verdict);
        report.headlines = ending_headlines(joint, verdict);
    }
    if (t.reason != Reason::none)
        report.alerts.push_back({Headline::Tone::warning, "The simulation stops: " + stop_text(t) + "."});
    if (t.used_fallback)
        report.alerts.push_back({Headline::Tone::neutral, "CVODE failed; Rodas5P finished the simulation."});
    Section section{"motion", "Motion", "", {}, {}};
    section.figures.push_back(
        line_figure("velocity", chart_of("Velocity in time", time, velocity, {{"V", t.time, t.velocity}}),
                    "Velocity of the link after the disturbance.", "In the last third it stays " + last_third + "."));
    auto in_time = chart_of("Excess position in time", time, position, {{"x", t.time, t.position}});
    if (surroundings.linear && surroundings.normal_load.value.empty())
        in_time.lines.push_back(linear_line(surroundings.linear->memory, t));
    section.figures.push_back(line_figure(
        "position", std::move(in_time), "Position of the link beyond its steady path.",
        "In the last third it stays " + range(settled(curves, t.position), Quantity::position, units) + "."));
    section.figures.push_back(path_figure(t, sliding_velocity(joint), curves.control_force, units));
    section.figures.push_back(
        line_figure("phase",
                    chart_of("Phase portrait", position, velocity,
                             {{"whole motion", t.position, t.velocity, true},
                              {"last third", settled(curves, t.position), settled(curves, t.velocity)}}),
                    "Velocity over excess position; solid is what the motion has settled to.",
                    "Velocity over excess position; the last third encloses velocities " + last_third + "."));
    section.figures.push_back(line_figure(
        "loop", chart_of("Friction over velocity", velocity, friction, friction_loop(t, curves)),
        "Friction against velocity. Where the motion leaves the dashed curve of steady sliding, friction remembers or "
        "holds the joint at rest.",
        "In the last third friction stays " + range(settled(curves, t.friction), Quantity::effort, units) + "."));
    report.sections.push_back(std::move(section));
    if (forced) report.sections.push_back(surroundings_section(surroundings, time, units));
    Section outcome{"outcome", "Where this disturbance ends", "", {}, {nonlinear_table(joint, verdict)}};
    if (forced) outcome.title = "Where the stated disturbance alone ends";
    report.sections.push_back(std::move(outcome));
    report.not_checked = not_checked(verdict);
    return report;
}

}  // namespace stickslip
