// The page about one joint.
#include "sweep/program/verbs/evaluated.h"

#include "analysis/stability/stable_gains.h"
#include "sweep/engine/build.h"
#include "sweep/report/pages/linear_report.h"
#include "sweep/report/pages/load_section.h"
#include "sweep/report/write_report.h"
#include "sweep/words/integral_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/low_limit_text.h"
#include "sweep/words/neighbour_text.h"
#include "sweep/words/open_text.h"
#include "sweep/words/set_point_text.h"

namespace stickslip {

std::filesystem::path write_evaluated(const Evaluated& e, const EvaluateOptions& options, const std::string& command)
{
    const auto answer = answer_joint(e.summed, e.verdict, e.nonlinear, *e.study);
    auto report = linear_report(e.summed, answer);
    const auto& own = e.verdict.state_variable.stable_intervals;
    const BothLoops both =
        e.described ? BothLoops{own, stable_gains(*e.described).stable} : BothLoops{answer.ideal_gains, own};
    if (const auto chart = gain_chart(e.described ? *e.described : e.summed))
        report.sections.insert(report.sections.begin(), gains_section(e.units(), both, *chart));
    if (e.described) {
        const bool same = (e.described_growth < 0) == e.verdict.state_variable.stable;
        report.alerts.push_back({same ? Headline::Tone::neutral : Headline::Tone::warning,
                                 left_out_text(left_out_by_ideal(*e.described), e.described_growth)});
        report.verdict = of_ideal_loop(report.verdict);
        // what the loop as it is does not do is no clean yes
        if (!same && report.tone == Headline::Tone::good) report.tone = Headline::Tone::warning;
    }
    if (e.verdict.steady.reason == Reason::limit_too_low)
        report.alerts.push_back({Headline::Tone::bad, low_limit_text(e.joint)});
    report.provenance = {{"version", program_version()}, {"command", command}};
    if (e.motion)
        for (auto& section : report.sections)
            if (section.id == "response")
                section.figures.push_back(disturbance_figure(e.joint, options.surroundings.force, *e.motion));
    if (e.open()) {
        report.verdict = open_text(e.nonlinear) + " " + report.verdict;
        if (report.tone == Headline::Tone::good) report.tone = Headline::Tone::warning;
    }
    if (!e.contradicting.empty()) {
        report.verdict = contradicted_text(e.contradicting, e.verdict.state_variable.stable) + " " + report.verdict;
        report.tone = e.verdict.state_variable.stable ? Headline::Tone::bad : Headline::Tone::warning;
    }
    if (e.only_rest()) report.verdict = set_point_text(*e.rest, e.units());
    if (e.rest) report.sections.insert(report.sections.end() - 1, set_point_section(*e.rest, e.units()));
    if (e.loads) report.sections.insert(report.sections.end() - 1, load_section(e.joint, *e.loads));
    for (const auto& mode : e.near) report.alerts.push_back(near_mode_alert(mode, e.units()));
    if (e.integral)
        report.alerts.push_back({e.integral->with > 0 ? Headline::Tone::neutral : Headline::Tone::warning,
                                 integral_text(*e.integral, e.units())});
    return write_report(report, options.directory);
}

}  // namespace stickslip
