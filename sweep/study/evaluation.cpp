#include "sweep/study/evaluation.h"

#include "analysis/joint/sum_of_gains.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/real_loop.h"
#include "analysis/stability/stable_gains.h"
#include "sweep/study/root_locus.h"

namespace stickslip {
namespace {

/// What the theory says over the given record of the normal load.
std::optional<LoadStudy> loaded(const Joint& joint, const std::optional<TimeSeries>& record)
{
    if (!record) return std::nullopt;
    return load_study(joint, record->sampled(record->duration() / sampled_disturbance, sampled_disturbance));
}

/// At a set point: of a loop that integrates or has something against dry friction there, and where that is commanded.
std::optional<SetPoint> resting(const Joint& joint)
{
    const auto& c = joint.control;
    const bool helped = c.feed_forward.fed_back() || c.dither.amplitude > 0;
    if (!integrates(joint) && !helped && c.V0 != 0) return std::nullopt;
    return set_point(joint);
}

/// What studies are of: the sum of gains, whose k_p and k_v can be turned, where that is the same loop.
Joint acting_loop(const JointEvaluation& e)
{
    return is_sum_of_gains(e.joint.control) ? e.summed : without_stopped_integral(e.joint);
}

}  // namespace

JointEvaluation evaluate_joint(const EvaluationQuestion& question, const std::function<void(EvaluationStage)>& at)
{
    JointEvaluation e;
    e.joint = question.ideal_loop ? with_ideal_loop(question.joint) : question.joint;
    at(EvaluationStage::linear);
    e.verdict = linear_verdict(e.joint);
    add_margins(e.joint, e.verdict);
    e.summed = acting_joint(e.joint);
    const Joint acting = acting_loop(e);
    at(EvaluationStage::nonlinear);
    e.nonlinear = nonlinear_verdict(e.joint, question.nonlinear);
    at(EvaluationStage::study);
    if (question.study) {
        e.study = linear_study(acting);
        if (e.decided()) e.locus = coarse_root_locus(acting);
    }
    at(EvaluationStage::surroundings);
    e.force = question.force;
    if (e.decided()) {
        if (!e.force.kind.empty()) e.motion = disturbed_motion(acting, e.force);
        e.loads = loaded(acting, question.normal_load);
    }
    e.rest = resting(e.joint);
    e.near = near_modes(e.joint);
    e.contradicting = contradicting_terms(e.verdict, e.nonlinear);
    e.integral = integral_cost(e.joint, e.verdict);
    if (question.ideal_loop) e.left_out = left_out_loop(question.joint);
    return e;
}

EvaluationCharts evaluation_charts(const JointEvaluation& e)
{
    EvaluationCharts charts;
    const Joint acting = acting_loop(e);
    charts.answer = answer_joint(acting, e.verdict, e.nonlinear, *e.study);
    const auto& own = e.verdict.state_variable.stable_intervals;
    charts.gains = gain_chart(e.left_out ? e.left_out->joint : acting);
    charts.ideal_loop = e.left_out ? own : charts.answer.ideal_gains;
    charts.real_loop = e.left_out ? stable_gains(e.left_out->joint).stable : own;
    return charts;
}

}  // namespace stickslip
