#include "sweep/report/pages/evaluation_report.h"

#include "sweep/report/figures/disturbance_figure.h"
#include "sweep/report/pages/linear_report.h"
#include "sweep/report/pages/load_section.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/low_limit_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/open_text.h"
#include "sweep/words/set_point_text.h"

namespace stickslip {
namespace {

using Tone = Headline::Tone;

void add_alerts(const JointEvaluation& e, Report& report)
{
    if (e.left_out) tell_left_out(*e.left_out, e.verdict.state_variable.stable, report);
    if (e.verdict.steady.reason == Reason::limit_too_low) report.alerts.push_back({Tone::bad, low_limit_text(e.joint)});
    for (const auto& mode : e.near) report.alerts.push_back(near_mode_alert(mode, e.units()));
    if (e.integral)
        report.alerts.push_back(
            {e.integral->with > 0 ? Tone::neutral : Tone::warning, integral_text(*e.integral, e.units())});
}

/// The verdict with what stands in its way.
void complete_verdict(const JointEvaluation& e, Report& report)
{
    if (e.left_out) report.verdict = of_ideal_loop(report.verdict);
    if (e.open()) {
        report.verdict = open_text(e.nonlinear) + " " + report.verdict;
        if (report.tone == Tone::good) report.tone = Tone::warning;
    }
    if (!e.contradicting.empty()) {
        report.verdict = contradicted_text(e.contradicting, e.verdict.state_variable.stable) + " " + report.verdict;
        report.tone = e.verdict.state_variable.stable ? Tone::bad : Tone::warning;
    }
    if (e.only_rest()) report.verdict = set_point_text(*e.rest, e.units());
}

}  // namespace

Report evaluation_report(const JointEvaluation& e, const EvaluationCharts& charts)
{
    auto report = linear_report(e.summed, charts.answer);
    if (charts.gains)
        report.sections.insert(report.sections.begin(),
                               gains_section(e.units(), {charts.ideal_loop, charts.real_loop}, *charts.gains));
    add_alerts(e, report);
    complete_verdict(e, report);
    if (e.motion)
        for (auto& section : report.sections)
            if (section.id == "response") section.figures.push_back(disturbance_figure(e.joint, e.force, *e.motion));
    if (e.rest) report.sections.insert(report.sections.end() - 1, set_point_section(*e.rest, e.units()));
    if (e.loads) report.sections.insert(report.sections.end() - 1, load_section(e.joint, *e.loads));
    return report;
}

}  // namespace stickslip
