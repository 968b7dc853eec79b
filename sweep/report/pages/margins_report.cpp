#include "sweep/report/pages/margins_report.h"

#include "analysis/results/text.h"
#include "sweep/report/pages/robust_figure.h"
#include "sweep/words/heading_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/verdict_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// How decay turns into growth along each parameter that has a boundary.
Figure growth_figure(const MarginsAnswer& a)
{
    const Units units = units_of(a.joint);
    DetailedChart chart;
    chart.title = "Decay and growth while one parameter moves";
    chart.x_label = {"parameter, as a multiple of its value"};
    chart.y_label = {"max Re s", "1/s"};
    chart.x_log = true;
    std::string crossings;
    for (std::size_t i = 0; i < a.alone.size(); ++i) {
        if (!a.alone[i].found) continue;
        const auto& move = a.alone[i].moves[0];
        const auto name = coordinate_text(a.alone_of[i], units);
        chart.lines.push_back({name, a.growth->lines[i].x, a.growth->lines[i].y});
        crossings += (crossings.empty() ? "" : ", ") + name + " at " + plain_number(move.to / move.from) + " times";
    }
    const double reach = a.growth->reach;
    chart.lines.push_back(
        {"boundary", {std::exp(-reach), std::exp(reach)}, {0, 0}, false, DetailedChart::Line::Look::rule});
    chart.x_marks.emplace_back("as given", 1);
    Figure figure;
    figure.id = "growth-by-parameter";
    figure.finding =
        "Largest real part of the spectrum while one parameter moves. It crosses zero for " + crossings + " its value.";
    figure.caption =
        "How to read it: all lines meet at the joint as given, and each follows one parameter; below zero disturbances "
        "decay. Where a line crosses zero lies the boundary, and the slope shows how fast growth sets in beyond it. "
        "Lines end where decay or growth exceeds " +
        plain_number(shown_growth) + " times that of the joint.";
    figure.picture = std::move(chart);
    return figure;
}

/// The parameter that has the shortest way to its boundary, alone.
const NearestMove* shortest_alone(const MarginsAnswer& a)
{
    const NearestMove* found = nullptr;
    const auto length = [](const NearestMove& m) { return std::abs(std::log(m.to / m.from)); };
    for (const auto& n : a.alone)
        if (n.found && (!found || length(n.moves[0]) < length(*found))) found = &n.moves[0];
    return found;
}

void add_headlines(Report& report, const MarginsAnswer& a)
{
    using Tone = Headline::Tone;
    const Units units = units_of(a.joint);
    report.headlines.push_back(nearest_headline(a.nearest, units));
    name_symbols(report, a.nearest, units);
    if (const auto* move = shortest_alone(a)) {
        const auto quantity = quantity_of(a.joint, move->path);
        report.headlines.push_back(
            {Tone::neutral,
             coordinate_text({move->path, move->less}, units) + " " + signed_percent(move->to / move->from - 1),
             "is the nearest boundary for one parameter alone: " +
                 range_text(move->from, move->to, quantity, units, from_to, 4)});
    }
    if (a.nearest.found)
        report.headlines.push_back({Tone::neutral, all_at_once(a.nearest.distance, scales_of(a)),
                                    "in " + uncertain_numbers(a.nearest, units) +
                                        " at once cannot reach the boundary (distance " +
                                        plain_number(a.nearest.distance) + ")"});
    if (a.worst) {
        const double growth = a.worst->instability;
        report.headlines.push_back({growth < 0 ? Tone::good : Tone::bad, with_unit(growth, Quantity::rate, units),
                                    "max Re s of the worst joint within the stated uncertainty; stable below 0"});
    }
}

}  // namespace

Report margins_report(const MarginsAnswer& a)
{
    Report report;
    report.title = page_title("Margins", a.title);
    report.subtitle =
        gains_text(a.joint) + " · V_{0} = " + with_unit(a.joint.control.V0, Quantity::velocity, units_of(a.joint));
    report.verdict = margins_text(a);
    const bool doubtful = a.worst && a.worst->instability >= 0;
    report.tone = !a.nearest.decided              ? Headline::Tone::warning
                  : a.nearest.stable && !doubtful ? Headline::Tone::good
                                                  : Headline::Tone::bad;
    report.tone = without_what_matters(report.tone, a.loop);
    if (a.left_out) {
        tell_left_out(*a.left_out, a.nearest.stable, report);
        report.verdict = of_ideal_loop(report.verdict);
    }
    if (a.nearest.decided) add_headlines(report, a);
    Section section{"margins", "Margins", "", {}, {alone_table(a)}};
    if (a.robust_set) section.figures.push_back(robust_figure(a));
    if (a.growth) section.figures.push_back(growth_figure(a));
    if (a.nearest.decided) report.sections.push_back(std::move(section));
    report.not_checked = {
        "Large disturbances: margins are those of the linear theory.",
        "A boundary beyond a factor of ten, or a stable pocket narrower than the steps along a direction."};
    report.provenance = {{"command", a.command}};
    return report;
}

}  // namespace stickslip
