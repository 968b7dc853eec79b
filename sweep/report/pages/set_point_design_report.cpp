#include "sweep/report/pages/set_point_design_report.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/line_figure.h"
#include "sweep/words/set_point_design_text.h"

#include <algorithm>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

const SetPointChoice* choice_of(const SetPointDesign& design, SetPointWay way)
{
    for (const auto& c : design.choices)
        if (c.way == way) return &c;
    return nullptr;
}

const SetPointChoice* best_of(const SetPointDesign& design)
{
    return design.best < 0 ? nullptr : &design.choices[static_cast<std::size_t>(design.best)];
}

void add_headlines(const SetPointDesignAnswer& a, Report& report)
{
    const Units units = units_of(a.joint);
    const auto* best = best_of(a.design);
    if (!best) return;
    const auto add = [&](Tone tone, double value, Quantity quantity, std::string meaning) {
        report.headlines.push_back({tone, with_unit(value, quantity, units), std::move(meaning)});
    };
    const bool near = best->rest_error <= a.rest_error;
    add(near ? Tone::good : Tone::bad, best->rest_error, Quantity::position,
        "largest error at rest" + (a.rest_error < infinity
                                       ? "; allowed: " + with_unit(a.rest_error, Quantity::position, units)
                                       : std::string()));
    add(Tone::neutral, best->k_i, Quantity::integral_gain, "integral gain k_{i}");
    // what the ends of the window are ends of depends on the way: with a push and a dead zone it is the dead zone
    const bool push_alone = !(best->dead_zone > 0);
    if (best->dead_zone > 0)
        add(Tone::neutral, best->dead_zone, Quantity::position,
            "dead zone of the error; at least " + with_unit(best->low, Quantity::position, units));
    if (best->push != 0)
        add(Tone::neutral, best->push, Quantity::command,
            push_alone
                ? "push towards the set point; may lie " + range_text(best->low, best->high, Quantity::command, units)
                : "push towards the set point");
    if (best->dither > 0)
        add(Tone::neutral, best->dither, Quantity::command,
            "amplitude of the dither; below " + with_unit(best->high, Quantity::command, units));
}

/// Where hunting ends, and where a push alone would move the joint.
Section push_section(const SetPointDesignAnswer& a)
{
    const Units units = units_of(a.joint);
    LineChart chart;
    chart.title = "Where the joint stops, against the push towards the set point";
    chart.x_label = {"push", std::string(unit_of(Quantity::command, units))};
    chart.y_label = {"distance from the set point", std::string(unit_of(Quantity::position, units))};
    chart.lines.push_back({"friction as described", a.scan.push, a.scan.amplitude});
    std::string reading = "Distance at which hunting stops, 0 where the joint settles; k_{i} = " +
                          with_unit(a.design.k_i_used, Quantity::integral_gain, units) + ".";
    if (const auto* push = choice_of(a.design, SetPointWay::push); push && is_set(push->low)) {
        const auto effort = [&](double value) { return with_unit(value, Quantity::command, units); };
        chart.x_marks.emplace_back("end of hunting", push->low);
        chart.x_marks.emplace_back("over-compensation", push->high);
        reading += push->low < push->high
                       ? " For every friction within the margin it settles " +
                             range_text(push->low, push->high, Quantity::command, units) + "."
                       : " No push works for every friction within the margin: it must exceed " + effort(push->low) +
                             " to end hunting, and stay below " + effort(push->high) + " so as not to move the joint.";
    }
    reading +=
        " A loop without delay stops at its set point under any push; one with ticks, dead time or lag overshoots each "
        "time, and an over-compensated joint moves back and forth.";
    auto figure = line_figure("push", std::move(chart), "Where the joint stops, against the push.", reading);
    return {"push-section", "Limits of the push", "", {std::move(figure)}, {}};
}

Section margin_section(const SetPointDesignAnswer& a)
{
    const Units units = units_of(a.joint);
    LineChart chart;
    chart.title = "Largest error at rest, against the uncertainty of friction";
    chart.x_label = {"uncertainty of static and kinetic friction (share)", "1"};
    chart.y_label = {"largest error at rest", std::string(unit_of(Quantity::position, units))};
    for (const auto way : {SetPointWay::no_integral, SetPointWay::push, SetPointWay::push_without_integral,
                           SetPointWay::dither_without_integral}) {
        LineChart::Line line{way_text(way), {}, {}};
        for (std::size_t i = 0; i < a.scan.designs.size(); ++i) {
            const auto* c = choice_of(a.scan.designs[i], way);
            if (!c || !c->holds) continue;
            line.x.push_back(a.scan.margins[i]);
            line.y.push_back(c->rest_error);
        }
        if (!line.x.empty()) chart.lines.push_back(std::move(line));
    }
    for (const auto way : {SetPointWay::dead_zone, SetPointWay::push_and_dead_zone})
        if (const auto* c = choice_of(a.design, way); c && c->holds)
            chart.lines.push_back({way_text(way), {a.friction_margin}, {c->rest_error}});
    chart.x_marks.emplace_back("specified", a.friction_margin);
    auto figure = line_figure("margin", std::move(chart),
                              "Largest error at rest of each solution, against the uncertainty of friction.",
                              "A line ends where its solution no longer prevents hunting for every friction. Dead "
                              "zones were searched at the specified margin only.");
    return {"margin-section", "Choices, and what friction may do", "", {std::move(figure)}, {}};
}

Section motion_section(const SetPointDesignAnswer& a)
{
    const Units units = units_of(a.joint);
    LineChart chart;
    chart.title = "Released near the set point";
    chart.x_label = {"time t", "s"};
    chart.y_label = {"error", std::string(unit_of(Quantity::position, units))};
    chart.lines.push_back({"integral alone", a.scan.before.time, a.scan.before.error, true});
    chart.lines.push_back({"best choice", a.scan.after.time, a.scan.after.error});
    auto figure = line_figure("motion", std::move(chart), "The error after the joint is released near its set point.",
                              "Simulated with the complete loop and the described friction, one motion each; k_{i} of "
                              "the dashed line: " +
                                  with_unit(a.design.k_i_used, Quantity::integral_gain, units) + ".");
    return {"motion-section", "How it moves", "", {std::move(figure)}, {}};
}

}  // namespace

Report set_point_design_report(const SetPointDesignAnswer& a, std::vector<Snippet> snippets)
{
    const Units units = units_of(a.joint);
    const auto* best = best_of(a.design);
    Report report;
    report.title = "A set point held without hunting";
    report.subtitle = "design of k_{i}, dead zone, push against dry friction and dither";
    report.verdict = set_point_design_text(a.design, units);
    report.tone = best && best->rest_error <= a.rest_error ? Tone::good : Tone::bad;
    report.snippets = std::move(snippets);
    add_headlines(a, report);
    if (!a.scan.push.empty()) report.sections.push_back(push_section(a));
    if (!a.scan.designs.empty()) report.sections.push_back(margin_section(a));
    if (!a.scan.after.time.empty()) report.sections.push_back(motion_section(a));
    report.sections.push_back({"choices", "Every way", "", {}, set_point_design_tables(a.design, units)});
    report.not_checked = {
        "Proofs hold for the loop without sampling, dead time, lag, filter and encoder; set-point-design.json lists "
        "what each leaves out. The motions are simulated with all of it.",
        "Friction is equal in both directions and at every position."};
    report.provenance = {{"command", a.command},
                         {"friction may be off by", plain_number(100 * a.friction_margin, 3) + " %"}};
    return report;
}

}  // namespace stickslip
