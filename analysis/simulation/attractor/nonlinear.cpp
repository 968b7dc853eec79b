// The verdict on one joint: where a disturbance ends, and which outcomes coexist.
#include "analysis/simulation/attractor/nonlinear.h"

#include "analysis/base/require_valid.h"
#include "analysis/loop/loop_use.h"
#include "analysis/simulation/attractor/attractor.h"
#include "analysis/simulation/attractor/criticality.h"
#include "analysis/simulation/attractor/growth.h"
#include "analysis/simulation/attractor/large_starts.h"
#include "analysis/simulation/attractor/loop_answer.h"
#include "analysis/simulation/attractor/slow_changes.h"
#include "analysis/simulation/flows/backwards.h"
#include "analysis/simulation/flows/delayed_flow.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double another_gain = 1.5;  ///< per k_p: at two gains only what nothing damps is neutral

void describe_cycle(const Attractor& a, NonlinearVerdict& verdict)
{
    verdict.period = a.kind == Attractor::Kind::irregular ? missing : a.period;
    verdict.amplitude = 0.5 * (a.position_max - a.position_min);
    verdict.velocity_min = a.velocity_min;
    verdict.velocity_max = a.velocity_max;
    verdict.stick_fraction = a.rest_time / a.period;
    verdict.multipliers.assign(a.multipliers.begin(), a.multipliers.end());
    verdict.repeats = a.repeats;
    verdict.path = a.path;
}

bool held_by_spring(const SlidingFlow& flow)
{
    return flow.k_p > 0;
}
bool held_by_spring(const ChainFlow& flow)
{
    return flow.gain() >= 0;  // beside a spring to the surroundings the loop may have none
}
bool held_by_spring(const DelayedFlow& flow)
{
    return held_by_spring(flow.chain());
}

/// The linear theory's side of the axis, and whether it is neutral whatever the gain: at a critical gain memory still
/// decides, but what nothing damps is left to itself.
struct LinearSide {
    double abscissa = missing;
    bool undamped = false;
};
LinearSide linear_side(const Joint& joint)
{
    LinearJoint linear = linear_joint(joint, steady_sliding(joint).slides_at);
    LinearSide side{loop_kind(joint) == LoopKind::ideal ? spectral_abscissa(linear) : growth_rate(joint)};
    linear.k_p *= another_gain;
    side.undamped = side.abscissa == 0 && spectral_abscissa(linear) == 0;
    return side;
}

void leave_open(Reason reason, NonlinearVerdict& verdict)
{
    verdict.outcome = Outcome::undecided;
    verdict.reason = reason;
    verdict.overshoot = missing;
}

/// Where the stated disturbance ends. A small one (`small`) that decays ends in steady sliding; one that grows is
/// lifted.
template <class AnyFlow>
Attractor end_of_stated(const AnyFlow& flow, const SlowMode& mode, const FlowVector& y0, bool small, bool decays,
                        const FollowOptions& options)
{
    if (small && decays) {
        Attractor steady;
        steady.kind = Attractor::Kind::steady;
        SlidingMotion first(flow, options.solver, options.rtol);
        first.start(y0);
        steady.first_peak = first.turn(mode.window()).position_max;
        return steady;
    }
    return follow(flow, small ? lifted(flow, mode, y0) : y0, decays, options);
}

void take_stated(const Attractor& stated, double deflection, NonlinearVerdict& verdict)
{
    verdict.outcome = stated.outcome();
    verdict.reason = stated.reason;
    verdict.path = stated.path;
    verdict.used_fallback |= stated.used_fallback;
    if (stated.cut_short) verdict.detail = Detail::limit_of_work;
    // of a motion whose end is known: what one has reached so far depends on where it was stopped; fmax ignores what is
    // missing
    if (verdict.outcome != Outcome::undecided && verdict.outcome != Outcome::solver_failure)
        verdict.overshoot = std::fmax(0, std::fmax(stated.first_peak, stated.position_max)) / deflection;
    if (stated.oscillates()) describe_cycle(stated, verdict);
}

/// The region of a joint whose small disturbances decay: whether a larger one ends in a cycle, and which.
template <class AnyFlow>
void try_larger(const AnyFlow& flow, const SlowMode& mode, const FollowOptions& options, FlowVector& cycle_start,
                NonlinearVerdict& verdict)
{
    Attractor large;
    const auto starts = large_starts(flow, mode);
    verdict.searched_from = starts.tried;
    for (const auto& start : starts.y) {
        if (!start.allFinite()) continue;
        large = follow(flow, start, true, options);
        verdict.used_fallback |= large.used_fallback;
        if (large.kind != Attractor::Kind::steady) break;
    }
    if (large.kind == Attractor::Kind::steady) verdict.region = NonlinearRegion::stable;
    if (large.oscillates()) {
        verdict.region = NonlinearRegion::bistable;
        describe_cycle(large, verdict);
        cycle_start = large.start;
    }
    if (verdict.region == NonlinearRegion::undecided) {
        verdict.reason = large.reason;
        if (large.cut_short) verdict.detail = Detail::limit_of_work;
    }
}

/// The verdict on equations of motion that exist: outcomes, each tried where those before did not decide.
template <class AnyFlow>
void judge(const Joint& joint, const AnyFlow& flow, const NonlinearOptions& options, NonlinearVerdict& verdict)
{
    FollowOptions follow_options;
    follow_options.solver = options.fallback_only ? Solver::rodas5p : Solver::cvode;
    follow_options.rtol = options.rtol;
    follow_options.turn_limit = options.turn_limit;
    follow_options.accelerate = options.accelerate;
    Work work(options.effort);
    if (options.accelerate) follow_options.work = &work;

    const auto mode = slow_mode(flow);
    if (!mode.shows_itself()) verdict.growth_missing = Detail::not_followed;
    if (!held_by_spring(flow)) {
        if (mode.shows_itself()) verdict.growth_rate = measure_growth(flow, mode, mode.right.real());
        return leave_open(Reason::diverges, verdict);
    }
    if (!mode.shows_itself())
        return leave_open(std::isfinite(mode.fastest) ? Reason::not_converged : Reason::not_finite, verdict);
    const auto kind = options.disturbance.kind;
    const bool stated_small = !is_set(options.disturbance.size);
    if (stated_small) verdict.disturbance.size = default_size(flow, mode, kind);

    const FlowVector y0 = disturbed(flow, mode, kind, verdict.disturbance.size);
    const bool no_states = kind == DisturbanceKind::state && (y0 - mode.steady).isZero(0);
    if (no_states) verdict.detail = Detail::no_state;
    if (no_states || !y0.allFinite())
        return leave_open(no_states ? Reason::unsupported : Reason::law_needs_motion, verdict);
    const FlowVector small = disturbed(flow, mode, kind, default_size(flow, mode, kind));
    verdict.growth_rate = growth_by_motion(flow, mode, small - mode.steady);
    const auto linear = linear_side(joint);
    // where a disturbance of some size is given, that one is followed
    if (linear.undamped && stated_small) return leave_open(Reason::neutral, verdict);
    const double least = measurable_growth * std::abs(mode.s);
    if (contradicts(verdict.growth_rate, linear.abscissa, least)) {
        verdict.growth_rate = missing;
        verdict.growth_missing = verdict.detail = Detail::growth_unresolved;
        return leave_open(Reason::not_converged, verdict);
    }
    const bool measurable = std::abs(verdict.growth_rate) > least;
    const bool decays = measurable ? verdict.growth_rate < 0 : linear.abscissa <= 0;

    const Attractor stated = end_of_stated(flow, mode, y0, stated_small, decays, follow_options);
    take_stated(stated, displaced(joint, steady_sliding(joint)), verdict);
    FlowVector cycle_start = stated.start;
    if (linear.undamped) {
        const bool sticks = stated.oscillates() && stated.rest_time > 0;
        return sticks ? void() : leave_open(Reason::neutral, verdict);
    }
    if (!decays) {
        verdict.region = NonlinearRegion::stick_slip;
    } else if (stated.oscillates()) {
        verdict.region = NonlinearRegion::bistable;
    } else if (options.region) {
        try_larger(flow, mode, follow_options, cycle_start, verdict);
    }
    if (!options.bifurcation || has_delayed_friction(joint)) return;
    add_bifurcation(joint, flow, cycle_start, verdict);
    const bool followed = joint.mechanism.model == Model::single_mass && verdict.velocity_min > 0;
    if (verdict.region == NonlinearRegion::bistable && std::isnan(verdict.fold_k_p))
        verdict.fold_missing = followed ? Detail::branch_lost : Detail::branch_not_smooth;
}

/// Of the ideal loop, in the coordinates of its flow.
NonlinearVerdict verdict_of_flow(const Joint& joint, const NonlinearOptions& options)
{
    NonlinearVerdict verdict;
    verdict.disturbance = options.disturbance;
    const auto judged = [&](const auto& found) {
        verdict.reason = found.reason;
        if (found.reason == Reason::none) {
            judge(joint, found.flow, options, verdict);
            if (std::isnan(verdict.growth_rate) && verdict.growth_missing == Detail::none)
                verdict.growth_missing = Detail::growth_unmeasured;
        } else {
            verdict.outcome = found.reason == Reason::linear_only ? Outcome::linear_only : Outcome::undecided;
            if (found.reason == Reason::unsupported) verdict.detail = why_no_flow(joint);
            verdict.growth_missing = Detail::not_followed;
        }
    };
    if (has_delayed_friction(joint))
        judged(delayed_flow(joint));
    else if (joint.mechanism.model == Model::single_mass)
        judged(sliding_flow(joint));
    else
        judged(chain_flow(joint));
    return verdict;
}

}  // namespace

std::string NonlinearOptions::problem() const
{
    return first_problem(tolerance_problem(rtol),
                         problem_unless(turn_limit >= 1, "turn_limit", turn_limit, "at least 1"),
                         problem_unless(effort > 0 && std::isfinite(effort), "effort", effort, "a number above 0"),
                         problem_unless(!std::isinf(disturbance.size), "disturbance.size", disturbance.size,
                                        "a finite number, or NaN for a small one"));
}

NonlinearVerdict nonlinear_verdict(const Joint& joint, const NonlinearOptions& options)
{
    require_valid(options);
    if (const auto slow = slow_change_verdict(joint, options)) return *slow;
    if (takes_ticks(joint)) return verdict_of(loop_verdict(joint, loop_question(options)), options);
    const double V0 = commanded_velocity(joint);
    if (!(V0 < 0)) return verdict_of_flow(joint, options);
    const Chain chain = chain_of(joint);
    NonlinearOptions along = options;
    along.disturbance = mirrored(options.disturbance, *chain.body[chain.bodies - 1].friction, V0);
    NonlinearVerdict verdict = verdict_of_flow(joint, along);
    if (is_set(options.disturbance.size)) verdict.disturbance = options.disturbance;
    const double least = verdict.velocity_min;
    verdict.velocity_min = 0 - verdict.velocity_max;
    verdict.velocity_max = 0 - least;
    return verdict;
}

}  // namespace stickslip
