#include "sweep/report/pages/linear_report.h"

#include "analysis/results/text.h"
#include "sweep/report/figures/loop_figures.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/figures/model_drawing.h"
#include "sweep/report/pages/comparison_section.h"
#include "sweep/report/pages/first_screen.h"
#include "sweep/report/pages/reduction_section.h"
#include "sweep/words/interval_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/verdict_text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

std::string model_name(Model model)
{
    for (const auto& m : models)
        if (m.value == model) return std::string(m.name);
    return "";
}

Headline demand(const char* theory, const std::vector<Interval>& stable, double own, Units units)
{
    if (stable.empty()) return {Tone::bad, "no k_{v}", std::string("is enough for smooth sliding, ") + theory};
    const bool within = std::any_of(stable.begin(), stable.end(), [&](const Interval& i) {
        return own < i.high && (own > i.low || (own == 0 && i.low == 0));
    });
    const auto tone = within ? Tone::good : Tone::neutral;
    const auto& [low, high] = stable.front();
    if (low == 0 && high == infinity)
        return {tone, "any k_{v}", std::string("is enough for smooth sliding, ") + theory};
    if (high == infinity)
        return {tone, with_unit(low, Quantity::velocity_gain, units),
                std::string("velocity gain k_{v} to exceed for smooth sliding, ") + theory};
    return {tone, required_text(stable, units), std::string("window of velocity gains for smooth sliding, ") + theory};
}

/// The worst reduction that still has the right number of boundaries, and how many have not.
void reduction_alerts(Report& report, const std::vector<ReductionStudy>& studies)
{
    constexpr double poor = 0.1;
    for (const auto& study : studies)
        if (study.compared() && study.own.error > poor)
            report.alerts.push_back(
                {Tone::warning,
                 "The reduction to " + study.model + " " +
                     (std::isinf(study.own.error) ? std::string("changes the number of boundaries of this joint")
                                                  : "moves the boundary by " + percent(study.own.error)) +
                     ": its assumption does not hold here."});
}

}  // namespace

std::vector<Section> linear_sections(const Joint& joint, const LinearDetails& details)
{
    std::vector<Section> sections;
    if (std::isnan(details.study.compliance)) return sections;
    sections.push_back(comparison_section(joint, details));
    sections.push_back(response_section(joint, details));
    if (details.ramps) sections.push_back(ramp_section(joint, details));
    if (!details.study.reductions.empty()) sections.push_back(reduction_section(joint, details.study.reductions));
    return sections;
}

namespace {

Headline gains_headline(const std::vector<Interval>& stable, const std::string& loop, Units units)
{
    return {Tone::neutral, intervals_text(stable, Quantity::position_gain, units), "stable k_{p} " + loop};
}

}  // namespace

Section gains_section(Units units, const BothLoops& stable, const GainChart& chart)
{
    Section section{
        "gains",
        "Safe gains: this loop and the paper's",
        "The paper's ideal loop acts at once and without limit. Stable k_{p} at this k_{v}: in the paper's loop " +
            intervals_text(stable.ideal, Quantity::position_gain, units) + ", in the loop as it is " +
            intervals_text(stable.real, Quantity::position_gain, units) +
            ". Colours and regions are those of the loop as it is.",
        {},
        {}};
    section.figures.push_back(map_figure(units, chart.slice, chart.answer));
    return section;
}

Report linear_report(const Joint& joint, const JointAnswer& answer)
{
    const auto& linear = answer.linear;
    const auto& study = answer.details.study;
    const Units units = units_of(joint);
    const bool decided = answer.slides;
    Report report;
    report.title = "One joint, both theories";
    report.subtitle = std::string(joint.control.kind == ControlKind::position ? "position control" : "force control") +
                      " · " + (units.motion == Motion::prismatic ? "prismatic" : "revolute") + " joint · " +
                      model_name(joint.mechanism.model);
    const auto verdict = design_verdict(joint, linear, answer.region, answer.nonlinear);
    report.verdict = verdict.text;
    report.tone = verdict.tone;
    if (decided) {
        const auto& c = study.comparison;
        const bool stable = linear.state_variable.stable;
        report.headlines = {nearest_headline(*answer.nearest, units)};
        name_symbols(report, *answer.nearest, units);
        if (linear.loop.kind == LoopKind::ideal) {
            report.headlines.push_back(
                demand("by the velocity-only model", c.k_v_velocity_only, joint.control.k_v, units));
            report.headlines.push_back(demand("with memory", c.k_v_memory, joint.control.k_v, units));
        } else if (joint.control.kind == ControlKind::position) {
            report.headlines.push_back(
                {Tone::neutral, stable_gains_text(joint, linear.state_variable), "stable k_{p} in the loop as it is"});
            report.headlines.push_back(gains_headline(answer.ideal_gains, "under the paper's ideal loop", units));
        }
        if (std::isfinite(linear.state_variable.k_cr))
            report.headlines.push_back({Tone::neutral,
                                        with_unit(linear.state_variable.k_cr, Quantity::position_gain, units),
                                        "critical position gain k_{cr}, at this k_{v} and velocity"});
        if (answer.velocities)
            report.headlines.push_back(velocity_headlines(*answer.velocities, stable, units).front());
        reduction_alerts(report, study.reductions);
        report.sections = linear_sections(joint, answer.details);
        for (auto& section : report.sections)
            if (section.id == "response")
                for (auto& figure : loop_figures(answer.locus, units)) section.figures.push_back(std::move(figure));
    }
    Section design{"numbers", "Numbers", "", {}, {}};
    if (decided) design.tables.push_back(linear_table(joint, linear));
    design.tables.push_back(nonlinear_table(joint, answer.nonlinear));
    report.sections.insert(report.sections.begin(), model_section(joint));
    report.sections.push_back(std::move(design));
    report.not_checked = {
        "Terms locked to position or time (ripple, cogging, drift, periodic forces) are not part of the linear theory.",
        linear.loop.kind == LoopKind::ideal
            ? "Sampling, delay, saturation and quantisation of a digital loop."
            : "Limits, dead zones and quantisation: a linear verdict is about motions that do not reach them."};
    return report;
}

}  // namespace stickslip
