#include "sweep/report/pages/design_report.h"

#include "analysis/loop/loop_use.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/words/heading_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

/// How the joint slides after the same disturbance, with the gains as given and with the best ones.
Section map_section(const DesignAnswer& a)
{
    const DesignUnits u{units_of(a.joint)};
    Figure figure = map_figure(units_of(a.joint), a.map->slice, a.map->answer);
    figure.caption +=
        " The cross is the best choice; the joint's own gains are k_{p} = " + u.stiffness(a.joint.control.k_p) +
        ", k_{v} = " + u.damping(a.joint.control.k_v) + ".";
    return {"map", "Where the gains lie", "", {std::move(figure)}, {}};
}

/// When the last of the lines has come to stay below a small part of the largest value of all, and a little longer.
double until_settled(const std::vector<LineChart::Line>& lines)
{
    constexpr double small = 0.02, longer = 1.15;
    double largest = 0, last = 0;
    for (const auto& line : lines)
        for (const double y : line.y) largest = std::max(largest, std::abs(y));
    for (const auto& line : lines)
        for (std::size_t i = 0; i < line.x.size(); ++i)
            if (std::abs(line.y[i]) > small * largest) last = std::max(last, line.x[i]);
    return longer * last;
}

void cut_after(LineChart::Line& line, double time)
{
    const auto end = std::upper_bound(line.x.begin(), line.x.end(), time) - line.x.begin();
    constexpr std::ptrdiff_t least = 2;  // a line needs two points
    const auto kept = static_cast<std::size_t>(std::max(end, std::min<std::ptrdiff_t>(least, std::ssize(line.x))));
    line.x.resize(kept), line.y.resize(kept);
}

Section motion_section(const DesignAnswer& a)
{
    const Units units = units_of(a.joint);
    const auto off = [](const Trajectory& t) {
        std::vector<double> excess;
        for (const double v : t.velocity) excess.push_back(v - t.commanded_velocity);
        return excess;
    };
    LineChart chart;
    chart.title = "Velocity after a small disturbance at V_{0} = " +
                  with_unit(a.motion.commanded_velocity, Quantity::velocity, units);
    chart.x_label = {"time t", "s"};
    chart.y_label = {"velocity off V_{0}", std::string(unit_of(Quantity::velocity, units))};
    if (!a.motion_before.time.empty())
        chart.lines.push_back({"gains as in the joint", a.motion_before.time, off(a.motion_before), true});
    chart.lines.push_back({"best gains", a.motion.time, off(a.motion)});
    Figure figure;
    figure.id = "motion";
    const double shown = until_settled(chart.lines);
    for (auto& line : chart.lines) cut_after(line, shown);
    figure.caption =
        "Simulated from the default disturbance of stickslip simulate, shown until both motions stay below 2 % of the "
        "largest deviation; one motion is one example.";
    figure.finding = chart.title;
    figure.picture = std::move(chart);
    return {"motion-section", "How it moves", "", {std::move(figure)}, {}};
}

std::vector<Headline> headlines(const DesignAnswer& a, const DesignUnits& u)
{
    const auto& d = a.design;
    std::vector<Headline> list;
    list.push_back({Tone::neutral, u.stiffness(d.best.k_p), "position gain k_{p}"});
    list.push_back({Tone::neutral, u.damping(d.best.k_v), "velocity gain k_{v}"});
    list.push_back(
        {Tone::neutral, u.position(std::abs(d.best.steady_deflection)), "steady deflection behind the reference"});
    list.push_back({Tone::neutral, u.position(d.best.motion_noise), "rms motion from sensor noise"});
    for (const auto& r : d.requirements)
        list.push_back(
            {r.met ? Tone::good : Tone::bad, requirement_value(r, r.achieved, a, u),
             (r.name == "margin" ? "margin: " + uncertain_numbers(a.nearest, units_of(a.joint)) + " may be off by " +
                                       off_text(a.margin_tolerance) + " at once; required: at least "
                                 : requirement_name(r.name) + "; required: at most ") +
                 requirement_value(r, r.specified, a, u)});
    return list;
}

/// Least noise over the margin, and the choices of the page on it.
Figure front_figure(const DesignAnswer& a, const DesignUnits& u)
{
    const auto& d = a.design;
    const bool motion = a.requirements.objective == DesignObjective::motion;
    LineChart chart;
    chart.title = std::string("Least ") + (motion ? "motion" : "effort") + " noise for each margin";
    chart.x_label = {"margin to the nearest boundary", "1"};
    chart.y_label = motion ? AxisName{"rms motion", std::string(unit_of(Quantity::position, u.units))}
                           : AxisName{"rms effort", std::string(unit_of(Quantity::effort, u.units))};
    const auto noise = [&](const GainChoice& c) { return motion ? c.motion_noise : c.effort_noise; };
    LineChart::Line line{"least noise", {}, {}};
    for (const auto& c : d.front) line.x.push_back(c.margin), line.y.push_back(noise(c));
    chart.lines.push_back(std::move(line));
    chart.x_marks.emplace_back("required", a.requirements.margin);
    const auto compared = [&](const char* name, const GainChoice& c) {
        if (c.margin > 0 && std::isfinite(noise(c))) chart.lines.push_back({name, {c.margin}, {noise(c)}});
    };
    compared("best", d.best);
    if (d.velocity_only_found) compared("velocity-only model", d.velocity_only);
    compared("as in the joint", d.as_joint);
    double least = infinity, most = 0;
    for (const auto& l : chart.lines)
        for (const double y : l.y) least = std::min(least, y), most = std::max(most, y);
    chart.y_log = most > 10 * least;
    Figure figure;
    figure.id = "noise-against-margin";
    figure.caption =
        "Pareto front: no gains within the range have both less noise and more margin, the other requirements "
        "kept. Points: the choices of the table below" +
        std::string(d.velocity_only.margin >= d.margin_reach || d.as_joint.margin >= d.margin_reach
                        ? "; margins are searched up to " + plain_number(d.margin_reach, 3) + "."
                        : ".");
    if (d.velocity_only_found && d.velocity_only.margin > 0)
        figure.caption += " The velocity-only model would choose " + gains_text(d.velocity_only, u) +
                          " with a noise of " +
                          (motion ? u.position(noise(d.velocity_only)) : u.effort(noise(d.velocity_only))) + ".";
    figure.finding = chart.title;
    figure.picture = std::move(chart);
    return figure;
}

Section front_section(const DesignAnswer& a, const DesignUnits& u)
{
    return {"pareto", "Noise against margin", "", {front_figure(a, u)}, {front_table(a)}};
}

}  // namespace

Report design_report(const DesignAnswer& a, std::vector<Snippet> snippets)
{
    const DesignUnits u{units_of(a.joint)};
    const auto& d = a.design;
    Report report;
    report.title = page_title("Design of gains", a.title);
    report.verdict = design_verdict_text(a);
    if (a.design.decided && a.design.feasible) name_symbols(report, a.nearest, units_of(a.joint));
    report.tone = without_what_matters(d.feasible ? Tone::good : Tone::bad, a.loop);
    if (a.left_out) {
        tell_left_out(*a.left_out, d.feasible, report);
        report.verdict = of_ideal_loop(report.verdict);
    }
    report.snippets = std::move(snippets);
    if (d.feasible) report.headlines = headlines(a, u);
    for (const auto& text : ends_of_range(a, u)) report.alerts.push_back({Tone::warning, text});
    if (a.map) report.sections.push_back(map_section(a));
    if (d.front.size() > 1) report.sections.push_back(front_section(a, u));
    if (!a.motion.time.empty()) report.sections.push_back(motion_section(a));
    Section choices{"choices", "Choices", "", {}, design_tables(a)};
    report.sections.push_back(std::move(choices));
    if (loop_kind(a.joint) == LoopKind::ideal)
        report.not_checked.push_back(
            "The joint file describes no sampling, dead time, filter or lag: a loop that has them allows other gains.");
    report.not_checked.push_back("Noise is white from sample to sample; the mechanism filters it linearly.");
    report.not_checked.push_back(
        "The range of gains is searched globally, then locally: an optimum narrower than the grid of the global search "
        "is not excluded.");
    report.provenance = {{"command", a.command}, {"pairs of gains evaluated", std::to_string(d.evaluations)}};
    return report;
}

}  // namespace stickslip
