#include "sweep/report/pages/margins_report.h"

#include "analysis/results/text.h"
#include "sweep/report/pages/robust_figure.h"
#include "sweep/words/heading_text.h"
#include "sweep/words/idle_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// How decay turns into growth along each parameter that has a boundary.
Figure growth_figure(const MarginsAnswer& a)
{
    DetailedChart chart;
    chart.title = "Decay and growth while one parameter moves";
    chart.x_label = {"parameter, as a multiple of its value"};
    chart.y_label = {"max Re s", "1/s"};
    chart.x_log = true;
    std::string crossings;
    for (std::size_t i = 0; i < a.alone.size(); ++i) {
        if (!a.alone[i].found) continue;
        const auto& move = a.alone[i].moves[0];
        const auto name = alone_name(a, i);
        chart.lines.push_back({name, a.growth->lines[i].x, a.growth->lines[i].y});
        crossings +=
            (crossings.empty() ? "" : ", ") + plain_number(move.to / move.from) + " times the value of " + name;
    }
    const double reach = a.growth->reach;
    chart.lines.push_back(
        {"boundary", {std::exp(-reach), std::exp(reach)}, {0, 0}, false, DetailedChart::Line::Look::rule});
    chart.x_marks.emplace_back("as given", 1);
    Figure figure;
    figure.id = "growth-by-parameter";
    figure.finding =
        "Largest real part of the spectrum while one parameter moves. It crosses zero at " + crossings + ".";
    figure.caption =
        "How to read it: all lines meet at the joint as given, and each follows one parameter; below zero disturbances "
        "decay. Where a line crosses zero lies the boundary, and the slope shows how fast growth sets in beyond it. "
        "Lines end where decay or growth exceeds " +
        plain_number(shown_growth) + " times that of the joint.";
    figure.picture = std::move(chart);
    return figure;
}

}  // namespace

Report margins_report(const MarginsAnswer& a)
{
    Report report;
    report.title = page_title("Margins", a.title);
    report.subtitle =
        gains_text(a.joint) + " · V_{0} = " + with_unit(a.joint.control.V0, Quantity::velocity, units_of(a.joint));
    report.verdict = margins_text(a);
    const bool worst_grows = a.worst && a.worst->instability >= 0,
               worst_is_open = a.worst && (std::isnan(a.worst->instability) || a.worst->undecided > 0);
    report.tone = !a.nearest.decided                 ? Headline::Tone::warning
                  : !a.nearest.stable || worst_grows ? Headline::Tone::bad
                  : worst_is_open                    ? Headline::Tone::warning
                                                     : Headline::Tone::good;
    report.tone = without_what_matters(report.tone, a.loop);
    tell_idle(a.idle, false, report);
    if (a.worst && a.only_idle() && report.tone == Headline::Tone::good) report.tone = Headline::Tone::warning;
    if (a.left_out) {
        tell_left_out(*a.left_out, a.nearest.stable, report);
        report.verdict = of_ideal_loop(report.verdict);
    }
    if (a.nearest.decided) {
        for (auto& headline : margins_headlines(a)) report.headlines.push_back(std::move(headline));
        name_symbols(report, a.nearest, units_of(a.joint));
    }
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
