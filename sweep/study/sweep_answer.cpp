#include "sweep/study/sweep_answer.h"

#include "analysis/boundary/trace/locate.h"
#include "analysis/joint/parameters.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/evaluate_points.h"

namespace stickslip {
namespace {

/// max Re s along an axis with friction replaced by its steady-state curve.
std::vector<double> velocity_only_abscissa(Joint joint, const Axis& axis)
{
    const auto number = number_at(joint, axis.path);
    std::vector<double> abscissa;
    for (const double value : axis.values) {
        number = value;
        abscissa.push_back(velocity_only_growth_rate(joint));
    }
    return abscissa;
}

ProfileAnswer answer_profile(const Joint& joint, const Profile& profile)
{
    const auto& axis = profile.axis;
    const Joint held = joint_at(joint, profile.held);
    const auto located = [&](Curve::Kind theory) {
        return locate_on_ray(held, axis.path, axis.values.front(), axis.values.back(), axis.log, theory);
    };
    return {velocity_only_abscissa(held, axis), located(Curve::Kind::state_variable),
            located(Curve::Kind::velocity_only)};
}

JointAnswer answer_design(const Spec& spec, const Joint& joint)
{
    NonlinearVerdict nonlinear;
    if (spec.nonlinear.enabled) {
        auto options = nonlinear_options(spec.nonlinear);
        options.bifurcation = true;
        nonlinear = nonlinear_verdict(joint, options);
    }
    JointQuestion question;
    const Axis* k_p = axis_of(spec, "control.k_p");
    question.locus = k_p && k_p->values.size() > 1;
    if (question.locus) question.lowest_gain = k_p->values.front(), question.highest_gain = k_p->values.back();
    const auto linear = linear_verdict(joint);
    const bool slides = linear.steady.reason == Reason::none;
    return answer_joint(joint, linear, nonlinear, slides ? linear_study(joint) : LinearStudy{}, question);
}

}  // namespace

bool fits(const SweepAnswer& answer, const SweepSummary& summary)
{
    bool same = answer.maps.size() == summary.slices.size() && answer.profiles.size() == summary.profiles.size() &&
                answer.panels.has_value() == summary.multiples.has_value();
    for (std::size_t i = 0; same && i < answer.maps.size(); ++i)
        same = answer.maps[i].layer_curves.size() == summary.slices[i].layers.size();
    for (std::size_t i = 0; same && i < answer.profiles.size(); ++i)
        same = answer.profiles[i].velocity_only_abscissa.size() == summary.profiles[i].axis.values.size();
    if (same && answer.panels) same = answer.panels->curves.size() == summary.multiples->panels.panels.size();
    return same && answer.design.slides == answer.design.nearest.has_value();
}

SweepAnswer answer_sweep(const Spec& spec, const SweepSummary& summary)
{
    const Joint joint = design_joint(spec);
    SweepAnswer answer;
    for (const auto& [name, value] : summary.provenance)
        if (name == "plan_id") answer.plan_id = value;
    answer.design = answer_design(spec, joint);
    answer.idle = idle_axes(joint, spec.axes);
    for (const auto& axis : spec.axes) answer.margins.push_back(margin_along(joint, axis));
    for (const auto& slice : summary.slices) answer.maps.push_back(answer_map(joint, slice));
    if (summary.multiples) answer.panels = answer_panels(joint, *summary.multiples);
    for (const auto& profile : summary.profiles) answer.profiles.push_back(answer_profile(joint, profile));
    for (const auto& [x, y] : spec.report.surfaces)
        if (const Axis* a = axis_of(spec, x), *b = axis_of(spec, y); a && b)
            answer.surfaces.push_back(gain_surface(joint, *a, *b));
    return answer;
}

}  // namespace stickslip
