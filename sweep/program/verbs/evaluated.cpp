#include "sweep/program/verbs/evaluated.h"

#include "analysis/joint/gains.h"
#include "analysis/loop/loop_use.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/frequency_search.h"
#include "analysis/stability/real_loop.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/files/toml/servo_text.h"
#include "sweep/program/verbs/no_sliding.h"

namespace stickslip {
namespace {

/// The motion under the given disturbance, if any.
std::optional<DisturbedMotion> disturbed(const Joint& joint, const AskedDisturbance& force)
{
    if (force.kind.empty()) return std::nullopt;
    return disturbed_motion(joint, force);
}

/// What the theory says over the given record of the normal load.
std::optional<LoadStudy> loaded(const Joint& joint, const SurroundingsOption& surroundings)
{
    if (!surroundings.loaded()) return std::nullopt;
    const auto record = surroundings.normal_load();
    return load_study(joint, record.sampled(record.duration() / sampled_disturbance, sampled_disturbance));
}

/// At a set point: of a loop that integrates or has something against dry friction there, and where that is commanded.
std::optional<SetPoint> resting(const Joint& joint)
{
    const auto& c = joint.control;
    const bool helped = c.feed_forward.fed_back() || c.dither.amplitude > 0;
    if (!integrates(joint) && !helped && c.V0 != 0) return std::nullopt;
    return set_point(joint);
}

}  // namespace

Evaluated evaluated(const EvaluateOptions& options, StageLine& line)
{
    auto asked = read_spec_or_joint(options.joint, options.settings);
    const Joint described = asked.design;
    if (options.ideal_loop) {
        asked.design = with_ideal_loop(asked.design);
        asked.spec.joint = with_ideal_loop(asked.spec.joint);
    }
    say_no_sliding(options.joint, options.settings, asked.design);
    set_search_effort(options.effort);
    Evaluated e;
    e.joint = asked.design;
    line.stage("the roots and the stable gains");
    e.verdict = linear_verdict(e.joint);
    add_margins(e.joint, e.verdict);
    e.summed = acting_joint(e.joint);
    NonlinearOptions nonlinear;
    nonlinear.bifurcation = true;
    nonlinear.disturbance = options.disturbance.disturbance(asked.spec.nonlinear);
    nonlinear.rtol = asked.spec.nonlinear.tolerance;
    nonlinear.effort = options.effort;
    line.stage("what the nonlinear joint does");
    e.nonlinear = nonlinear_verdict(e.joint, nonlinear);
    line.stage("reductions, force ramps and critical velocities");
    if (options.json || !options.directory.empty()) e.study = linear_study(e.summed);
    line.stage("the motion under load, and rest");
    if (e.decided()) {
        e.motion = disturbed(e.summed, options.surroundings.force);
        e.loads = loaded(e.summed, options.surroundings);
    }
    e.rest = resting(e.joint);
    e.near = near_modes(e.joint);
    e.contradicting = contradicting_terms(e.verdict, e.nonlinear);
    e.integral = integral_cost(e.joint, e.verdict);
    e.servo = files::servo_text(options.joint);
    if (options.ideal_loop && !left_out_by_ideal(described).used.empty()) {
        e.described = described.control.structure == Structure::cascade ? with_gains(described) : described;
        e.described_growth = growth_rate(described);
    }
    return e;
}

}  // namespace stickslip
