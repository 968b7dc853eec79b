#include "analysis/simulation/nonlinear.h"

#include "analysis/simulation/attractor.h"
#include "analysis/simulation/bifurcation.h"
#include "analysis/simulation/delay.h"
#include "analysis/simulation/growth.h"
#include "analysis/simulation/large_disturbance.h"
#include "analysis/stability/joint_spectrum.h"
#include "analysis/stability/spectrum.h"
#include "analysis/stability/steady.h"
#include "analysis/stability/verdict.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// A first Lyapunov coefficient, per ω, that decides nothing.
constexpr double degenerate_lyapunov = 1e-6;

/// To which a small disturbance that grows is lifted, in units of the flow's scale; and the size below which it excites
/// its mode so little that the lifted one would drown in the solver's tolerance.
constexpr double lifted = 0.1, hidden = 1e-3 * small_disturbance;

constexpr double neutral_abscissa = 1e-12;  ///< per |s|

Outcome outcome_of(const Attractor& a)
{
    using Kind = Attractor::Kind;
    switch (a.kind) {
        case Kind::steady:
            return Outcome::stable_sliding;
        case Kind::period_n:
            return Outcome::period_n;
        case Kind::irregular:
            return Outcome::irregular;
        case Kind::undecided:
            return Outcome::undecided;
        case Kind::failure:
            return Outcome::solver_failure;
        case Kind::held:
            return Outcome::stick_slip;
        case Kind::cycle:
            break;
    }
    if (a.reversed) return Outcome::reversal;
    return a.rest_time > 0 ? Outcome::stick_slip : Outcome::limit_cycle;
}

bool oscillates(const Attractor& a)
{
    using Kind = Attractor::Kind;
    return a.kind == Kind::cycle || a.kind == Kind::period_n || a.kind == Kind::irregular || a.kind == Kind::held;
}

void describe_cycle(const Attractor& a, NonlinearVerdict& verdict)
{
    verdict.period = a.period;
    verdict.amplitude = 0.5 * (a.position_max - a.position_min);
    verdict.velocity_min = a.velocity_min;
    verdict.velocity_max = a.velocity_max;
    verdict.stick_fraction = a.rest_time / a.period;
    verdict.multipliers.assign(a.multipliers.begin(), a.multipliers.end());
    verdict.repeats = a.repeats;
    verdict.path = a.path;
}

/// Criticality at k_cr, and the fold: from a subcritical Hopf point, or from the cycle that a bistable joint has.
void add_bifurcation(const Joint& joint, const Flow& flow, const FlowVector& cycle_start, NonlinearVerdict& verdict)
{
    const auto* single = dynamic_cast<const SlidingFlow*>(&flow);  // the branch of cycles is followed for one body

    const double k_cr = linear_verdict(joint).state_variable.k_cr;
    const CycleOptions options;
    if (std::isfinite(k_cr) && k_cr > 0) {
        const auto at_critical = flow.with_gain(k_cr);
        const auto hopf = hopf_point(*at_critical);
        verdict.lyapunov = hopf.lyapunov;
        const bool weak = !(std::abs(hopf.lyapunov) > degenerate_lyapunov * hopf.omega);
        verdict.criticality = weak                ? Criticality::degenerate
                              : hopf.lyapunov > 0 ? Criticality::subcritical
                                                  : Criticality::supercritical;
        if (!single) return;
        if (const auto fold = fold_of_cycles(*at_critical, hopf, options)) verdict.fold_k_p = fold->k_p;
    }
    const bool smooth = single && single->states > 0 && cycle_start.size() > 0 && verdict.velocity_min > 0;
    if (std::isnan(verdict.fold_k_p) && verdict.region == NonlinearRegion::bistable && smooth)
        if (const auto fold = fold_of_cycles(flow, BranchPoint{single->k_p, cycle_start}, options))
            verdict.fold_k_p = fold->k_p;
}

/// The verdict on equations of motion that exist, with the largest real part of the linear spectrum.
template <class AnyFlow>
void judge(const Joint& joint, const AnyFlow& flow, double abscissa, const NonlinearOptions& options,
           NonlinearVerdict& verdict)
{
    FollowOptions follow_options;
    follow_options.solver = options.fallback_only ? Solver::rodas5p : Solver::cvode;
    follow_options.rtol = options.rtol;
    follow_options.turn_limit = options.turn_limit;
    follow_options.accelerate = options.accelerate;

    const auto mode = slow_mode(flow);
    if (!mode.shows_itself()) {
        verdict.outcome = Outcome::undecided;
        verdict.reason = std::isfinite(mode.fastest) ? Reason::not_converged : Reason::not_finite;
        return;
    }
    const double deflection = steady_sliding(joint).deflection;
    const auto kind = options.disturbance.kind;
    const bool stated_small = !is_set(options.disturbance.size);
    if (stated_small) verdict.disturbance.size = default_size(flow, mode, kind);

    const FlowVector y0 = disturbed(flow, mode, kind, verdict.disturbance.size);
    const bool no_states = kind == DisturbanceKind::state && (y0 - mode.steady).isZero(0);
    if (no_states || !y0.allFinite()) {
        verdict.outcome = Outcome::undecided;
        verdict.reason = no_states ? Reason::unsupported : Reason::law_needs_motion;
        return;
    }
    const FlowVector small = disturbed(flow, mode, kind, default_size(flow, mode, kind));
    verdict.growth_rate = measure_growth(flow, mode, small - mode.steady);
    const bool measurable = std::abs(verdict.growth_rate) > measurable_growth * std::abs(mode.s);
    // a neutral mode, as of an undamped spring, does not grow
    const bool decays = measurable ? verdict.growth_rate < 0 : abscissa <= neutral_abscissa * std::abs(mode.s);

    // the stated disturbance
    Attractor stated;
    if (stated_small && decays) {
        stated.kind = Attractor::Kind::steady;
        SlidingMotion first(flow, follow_options.solver, options.rtol);
        first.start(y0);
        stated.first_peak = first.turn(mode.window()).position_max;
    } else {
        // a small disturbance that grows need not be watched while it is linear: its direction is known, its size is
        // not
        const double size = size_of(flow, mode, y0 - mode.steady);
        const double lift = stated_small ? lifted / (size < hidden ? size : small_disturbance) : 1;
        stated = follow(flow, mode.steady + lift * (y0 - mode.steady), decays, follow_options);
    }
    verdict.outcome = outcome_of(stated);
    verdict.reason = stated.reason;
    verdict.path = stated.path;
    verdict.used_fallback |= stated.used_fallback;
    // fmax ignores what is missing
    verdict.overshoot = std::fmax(0, std::fmax(stated.first_peak, stated.position_max)) / std::abs(deflection);
    if (oscillates(stated)) describe_cycle(stated, verdict);
    FlowVector cycle_start = stated.start;

    if (!decays) {
        verdict.region = NonlinearRegion::stick_slip;
    } else if (oscillates(stated)) {
        verdict.region = NonlinearRegion::bistable;
    } else if (options.region) {
        const auto large =
            follow(flow, disturbed(flow, mode, DisturbanceKind::start, near_rest_start), decays, follow_options);
        verdict.used_fallback |= large.used_fallback;
        if (large.kind == Attractor::Kind::steady) verdict.region = NonlinearRegion::stable;
        if (oscillates(large)) {
            verdict.region = NonlinearRegion::bistable;
            describe_cycle(large, verdict);
            cycle_start = large.start;
        }
        if (verdict.region == NonlinearRegion::undecided) verdict.reason = large.reason;
    }
    if (options.bifurcation) add_bifurcation(joint, flow, cycle_start, verdict);
}

}  // namespace

NonlinearVerdict nonlinear_verdict(const Joint& joint, const NonlinearOptions& options)
{
    if (const auto delayed = delayed_joint(joint); delayed && sliding_flow(joint).reason == Reason::unsupported)
        return delayed_verdict(joint, *delayed, options);
    NonlinearVerdict verdict;
    verdict.disturbance = options.disturbance;
    const auto judged = [&](const auto& found) {
        verdict.reason = found.reason;
        if (found.reason == Reason::none) {
            const auto linear = linear_joint(joint, steady_sliding(joint).velocity);
            judge(joint, found.flow, spectral_abscissa(linear), options, verdict);
        } else {
            verdict.outcome = found.reason == Reason::linear_only ? Outcome::linear_only : Outcome::undecided;
        }
    };
    if (joint.mechanism.model == Model::single_mass)
        judged(sliding_flow(joint));
    else
        judged(chain_flow(joint));
    return verdict;
}

}  // namespace stickslip
