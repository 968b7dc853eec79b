#include "sweep/report/pages/stability_report.h"

#include "analysis/joint/parameters.h"
#include "analysis/results/text.h"
#include "sweep/report/figures/loop_figures.h"
#include "sweep/report/figures/map_figures.h"
#include "sweep/report/figures/model_drawing.h"
#include "sweep/report/figures/multiples.h"
#include "sweep/report/figures/profile_figures.h"
#include "sweep/report/figures/reduction_map.h"
#include "sweep/report/pages/first_screen.h"
#include "sweep/report/pages/linear_report.h"
#include "sweep/words/idle_text.h"
#include "sweep/words/loop_text.h"
#include "sweep/words/nearest_text.h"
#include "sweep/words/reason_text.h"
#include "sweep/words/verdict_text.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;

constexpr std::size_t card_limit = 5;  // in one row; that nothing is wrong may be left out

std::string grid_words(const Spec& spec, std::uint64_t points)
{
    std::string text = grouped(points) + (points == 1 ? " point" : " points");
    std::string shape;
    for (const auto& axis : spec.axes)
        shape += (shape.empty() ? "" : " × ") + std::to_string(axis.values.size()) + " " + axis.symbol;
    return spec.axes.size() > 1 ? text + " (" + shape + ")" : text;
}

/// "rate-and-state friction", or one law a body.
std::string friction_words(const Joint& joint)
{
    const auto name = [](const Friction& f) { return std::string(info(f.law).name); };
    if (joint.mechanism.model == Model::single_mass) return name(joint.friction) + " friction";
    const auto& f = joint.frictions;
    return "friction " + name(f.motor) + " on the motor, " +
           (f.has_transmission ? name(f.transmission) + " on the transmission, " : "") + name(f.link) + " on the link";
}

std::string subtitle(const Spec& spec, const Joint& joint, std::uint64_t points)
{
    return std::string(joint.control.kind == ControlKind::position ? "position control" : "force control") + " · " +
           (joint.mechanism.motion == Motion::prismatic ? "prismatic" : "revolute") + " joint · " +
           friction_words(joint) + " · " + grid_words(spec, points);
}

Headline disagreement_headline(const StabilityMap& map)
{
    return {Tone::neutral, percent(map.disagreement),
            "of the first map, over " + map.x.symbol + " and " + map.y.symbol + ": the velocity-only model is wrong"};
}

Headline undecided_headline(const SweepSummary& summary)
{
    const double share =
        summary.points ? static_cast<double>(summary.undecided) / static_cast<double>(summary.points) : 0;
    return {summary.undecided ? Tone::warning : Tone::good, percent(share),
            "of the " + grouped(summary.points) + " points are undecided"};
}

/// `near`: the design lies close to its boundary.
void add_alerts(Report& report, const SweepSummary& summary, const std::vector<const StabilityMap*>& maps, bool near)
{
    for (const auto* map : maps)
        if (!map->design.inside)
            report.alerts.push_back({Tone::warning, "The design point lies outside the chart over " + map->x.name +
                                                        " and " + map->y.name + "."});
    if (near)
        report.alerts.push_back(
            {Tone::warning, "The design lies within a factor of " + plain_number(near_factor) + " of its boundary."});
    if (summary.held > 0)
        report.alerts.push_back(
            {Tone::warning, grouped(summary.held) + (summary.held == 1 ? " point comes" : " points come") +
                                " to rest for good after the stated disturbance: the limits leave less effort "
                                "than breaks static friction."});
    for (const auto& [reason, count] : summary.reasons)
        report.alerts.push_back({Tone::warning, grouped(count) + (count == 1 ? " point has" : " points have") +
                                                    " no verdict: " + reason_text(reason) + "."});
}

std::vector<std::string> not_checked(const Spec& spec, const LoopUse& loop)
{
    std::vector<std::string> list;
    if (!spec.nonlinear.enabled)
        list.push_back(
            "Large disturbances: the verdicts are those of the linear theory, and hold for small ones. "
            "Simulate the points with [nonlinear] enabled = true.");
    else
        list.push_back("Other or larger disturbances than the stated one.");
    list.push_back(
        "Terms locked to position or time (ripple, cogging, drift, periodic forces) are not part of these "
        "verdicts.");
    if (loop.kind == LoopKind::ideal) list.push_back("Sampling, saturation and quantisation of a digital loop.");
    list.push_back("Whether the parameters are those of your machine: compare records with stickslip diagnose.");
    return list;
}

/// A map whose design, where the chart goes through it, is told with what simulating it has shown.
MapAnswer with_end(MapAnswer map, Joint joint, const Slice& slice, const JointAnswer& own)
{
    const bool through = std::ranges::all_of(
        slice.held, [&](const Held& held) { return *find_parameter(joint, held.axis.path) == held.value; });
    if (!through || own.nonlinear.outcome == Outcome::not_asked) return map;
    map.design.region = own.region;
    return map;
}

Section outcome_section(const Joint& joint, const SweepSummary& summary, const SweepAnswer& answer)
{
    const Units units = units_of(joint);
    Section outcomes{"outcomes", "Limit cycles", "", {}, {}};
    for (std::size_t i = 0; i < summary.slices.size(); ++i)
        for (auto& figure : outcome_figures(units, summary.slices[i], answer.maps[i]))
            outcomes.figures.push_back(std::move(figure));
    for (const auto& profile : summary.profiles)
        for (auto& figure : outcome_profiles(joint, profile)) outcomes.figures.push_back(std::move(figure));
    return outcomes;
}

Section gain_section(const SweepAnswer& answer, Units units)
{
    Section gains{"critical-gain", "Critical position gain", "", {}, {}};
    for (const auto& surface : answer.surfaces) gains.figures.push_back(surface_figure(surface, units));
    for (auto& figure : loop_figures(answer.design.locus, units)) gains.figures.push_back(std::move(figure));
    return gains;
}

Section design_section(const Spec& spec, const Joint& joint, const SweepAnswer& answer)
{
    Section design{"design", "The design point", "", {model_drawing_figure(joint, "lumped-model")}, {}};
    if (!answer.margins.empty()) design.tables.push_back(margin_table(answer.margins, units_of(joint)));
    if (answer.design.slides) design.tables.push_back(linear_table(joint, answer.design.linear));
    if (spec.nonlinear.enabled) design.tables.push_back(nonlinear_table(joint, answer.design.nonlinear));
    return design;
}

void tell_ideal_loop(const SweepAnswer& answer, Report& report)
{
    if (!answer.left_out) return;
    const Region region = answer.design.region;
    tell_left_out(*answer.left_out, region == Region::stable || region == Region::memory_only, report);
    report.verdict = of_ideal_loop(report.verdict);
}

/// What the verdict on the design does not answer for: another loop, axes without a term, points without a verdict.
void tell_limits(const Spec& spec, const SweepSummary& summary, const SweepAnswer& answer, Report& report)
{
    tell_ideal_loop(answer, report);
    tell_idle(answer.idle, spec.nonlinear.enabled, report);
    if (summary.undecided == summary.points && report.tone == Tone::good) report.tone = Tone::warning;
}

/// A line without a verdict has nothing to draw.
void add_profiles(const Joint& joint, const SweepSummary& summary, const SweepAnswer& answer, Section& maps)
{
    for (std::size_t i = 0; i < summary.profiles.size(); ++i)
        if (std::ranges::any_of(summary.profiles[i].abscissa, [](double a) { return std::isfinite(a); }))
            maps.figures.push_back(profile_figure(joint, summary.profiles[i], answer.profiles[i]));
}

}  // namespace

Report stability_report(const Spec& spec, const SweepSummary& summary, const SweepAnswer& answer)
{
    const Joint joint = design_joint(spec);
    const Units units = units_of(joint);
    const JointAnswer& own = answer.design;
    const auto& linear = own.linear;
    const bool stable = linear.state_variable.stable, slides = own.slides;

    Report report;
    report.title = !spec.report.title.empty() ? spec.report.title
                   : !spec.title.empty()      ? spec.title
                                              : "Where the joint slides smoothly";
    report.subtitle = subtitle(spec, joint, summary.points);
    const bool rests = own.nonlinear.comes_to_rest();
    const auto verdict = design_verdict(joint, linear, own.region, own.nonlinear);
    report.verdict = verdict.text;
    report.tone = verdict.tone;
    tell_limits(spec, summary, answer, report);
    const auto& margins = answer.margins;
    Section maps{"maps", "Stability maps", "", {}, {}};
    for (std::size_t i = 0; i < summary.slices.size(); ++i)
        maps.figures.push_back(
            map_figure(units, summary.slices[i], with_end(answer.maps[i], joint, summary.slices[i], own), rests));
    std::vector<const StabilityMap*> drawn;
    for (const auto& figure : maps.figures) drawn.push_back(&std::get<StabilityMap>(figure.picture));

    if (slides) {
        report.headlines.push_back(nearest_headline(*own.nearest, units));
        name_symbols(report, *own.nearest, units);
        report.headlines.push_back(nearest_boundary_headline(margins, stable, units));
        if (own.velocities)
            for (auto& headline : velocity_headlines(*own.velocities, stable, units))
                report.headlines.push_back(std::move(headline));
    }
    if (!drawn.empty()) report.headlines.push_back(disagreement_headline(*drawn.front()));
    if (summary.undecided > 0 || report.headlines.size() < card_limit)
        report.headlines.push_back(undecided_headline(summary));
    if (own.region == Region::bistable)
        report.alerts.push_back(
            {Tone::warning, std::string("Margins and velocities are for small disturbances: a larger one ") +
                                (rests ? "leaves the joint at rest for good."
                                       : "ends in stick-slip in the whole dotted region of the map.")});
    add_alerts(report, summary, drawn, slides && stable && near_boundary(margins));

    if (summary.multiples) maps.figures.push_back(multiples_figure(*summary.multiples, *answer.panels, units));
    for (std::size_t i = 0; i < summary.slices.size(); ++i)
        if (const auto& reduced = answer.maps[i].reduced)
            maps.figures.push_back(reduction_map(summary.slices[i], *reduced, units));
    add_profiles(joint, summary, answer, maps);
    if (!maps.figures.empty()) report.sections.push_back(std::move(maps));

    if (auto outcomes = outcome_section(joint, summary, answer); !outcomes.figures.empty())
        report.sections.push_back(std::move(outcomes));
    if (auto gains = gain_section(answer, units); !gains.figures.empty()) report.sections.push_back(std::move(gains));
    report.sections.push_back(design_section(spec, joint, answer));
    for (auto& section : linear_sections(joint, own.details)) report.sections.push_back(std::move(section));

    report.not_checked = not_checked(spec, linear.loop);
    report.provenance = summary.provenance;
    return report;
}

}  // namespace stickslip
