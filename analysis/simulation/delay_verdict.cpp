#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <numbers>

#include "analysis/simulation/delay.h"
#include "analysis/simulation/nonlinear.h"
#include "analysis/simulation/repeats.h"
#include "analysis/stability/verdict.h"

namespace stickslip {
namespace {

constexpr double linear_size = 1e-6;  ///< of V_0: the small disturbance
constexpr double probe_size = 1e-4;   ///< of V_0: the one whose growth is measured
constexpr double growth_fineness = 1e-2;
constexpr double finest_tolerance = 1e-13;  ///< beside forces of some N whose rounding enters
constexpr double settled_size = 1e-5;       ///< of V_0: steady sliding again
constexpr double closed = 1e-6;             ///< relative gap of a closed orbit
constexpr double turn_limit_in_turns = 1e3;
constexpr int settling_turns = 60;  ///< before a motion that does not close is tested for longer repeats

/// Growth per time of the slowest mode s, measured over one turn or a factor of 3. With l the left null vector of
/// sI − A_0 − A_1 e^{−sτ}, z = l·X + ∫ e^{−s(ξ+τ−t)} l·A_1 X(ξ) dξ over the last lag obeys z' = s z exactly, whatever
/// the endless other modes do (J. K. Hale, Theory of Functional Differential Equations, 7.3). Motions from both sides
/// of steady sliding cancel the even powers of the disturbance.
double measured_growth(const DelayedJoint& joint, std::complex<double> s, double rtol)
{
    const double window = growth_window(s);
    const double start = probe_size * joint.V0 * natural_time(joint);
    const double slope = steady_slope(joint.curve, joint.V0);
    const std::complex<double> by_position = -joint.k_p / (joint.inertia * s);
    std::complex<double> difference = 0;
    for (const double side : {1.0, -1.0}) {
        DelayMotion motion(joint, std::max(growth_fineness * rtol * probe_size, finest_tolerance));
        motion.start(side * start, joint.V0);
        while (motion.time() < window) {
            const auto end = motion.turn(window, 0).end;
            if (end == Turn::End::failure || end == Turn::End::held) return missing;
        }
        difference +=
            side * (by_position * motion.position() + motion.excess_speed() - slope / joint.inertia * motion.memory(s));
    }
    return std::log(std::abs(difference / (2 * start * by_position))) / window;
}

struct End {
    Outcome outcome = Outcome::undecided;
    Reason reason = Reason::none;
    Turn turn;
    int repeats = 1;
};

/// The longest time at rest: the spring winds up from one static friction to the other.
double wind_up_time(const DelayedJoint& joint)
{
    return 2 * joint.static_force() / (joint.k_p * joint.V0);
}

bool grows_and_shrinks(const std::deque<Turn>& turns)
{
    int grew = 0, shrank = 0;
    for (std::size_t i = 1; i < turns.size(); ++i) ++(turns[i].state[0] > turns[i - 1].state[0] ? grew : shrank);
    return grew > 0 && shrank > 0;
}

End follow(const DelayedJoint& joint, PositionAndSpeed from, const NonlinearOptions& options)
{
    DelayMotion motion(joint, options.rtol);
    motion.start(from.x, from.V);
    const double longest = turn_limit_in_turns * natural_time(joint) + wind_up_time(joint);
    End end;
    std::deque<Turn> turns;  // newest last
    double size = 0;
    const auto gap = [&](int i, int j) { return std::abs(turns[i].state[0] - turns[j].state[0]); };
    for (int i = 0; i < options.turn_limit; ++i) {
        end.turn = motion.turn(motion.time() + longest, settled_size);
        const auto& turn = end.turn;
        if (turn.end == Turn::End::settled) {
            end.outcome = Outcome::stable_sliding;
            return end;
        }
        if (turn.reversed) {
            end.outcome = Outcome::reversal;
            end.reason = Reason::law_needs_motion;  // how it goes on is beyond the law
            return end;
        }
        if (turn.end != Turn::End::crossing) {
            end.reason = turn.end == Turn::End::failure ? Reason::solver_failed : Reason::not_converged;
            return end;
        }
        turns.push_back(turn);
        if (turns.size() > 2 * longest_repeat + 2) turns.pop_front();
        size = std::max(std::abs(turn.position_min), std::abs(turn.position_max));
        if (size < settled_size * joint.V0 * natural_time(joint)) {  // a turn may be shorter than the lag
            end.outcome = Outcome::stable_sliding;
            return end;
        }
        if (i < 4) continue;
        const int m = turns_to_repeat(static_cast<int>(turns.size()), gap, closed * size);
        if (m == 0 || (m > 1 && i < settling_turns)) continue;
        end.turn = merged(turns, m);
        end.repeats = full_turns(turns, m);
        const bool rests = end.turn.rest_time > 0;
        end.outcome = end.repeats > 1 ? Outcome::period_n : rests ? Outcome::stick_slip : Outcome::limit_cycle;
        return end;
    }
    end.turn = merged(turns, static_cast<int>(turns.size()));
    if (grows_and_shrinks(turns))
        end.outcome = Outcome::irregular;
    else
        end.reason = Reason::not_converged;
    return end;
}

bool oscillates(Outcome outcome)
{
    return outcome == Outcome::stick_slip || outcome == Outcome::limit_cycle || outcome == Outcome::reversal ||
           outcome == Outcome::period_n || outcome == Outcome::irregular;
}

void describe(const DelayedJoint& joint, const End& end, NonlinearVerdict& verdict)
{
    if (end.outcome == Outcome::reversal) return;  // its motion ends where the law does
    const auto& turn = end.turn;
    verdict.repeats = end.repeats;
    verdict.amplitude = 0.5 * (turn.position_max - turn.position_min);
    verdict.velocity_min = turn.velocity_min;
    verdict.velocity_max = turn.velocity_max;
    verdict.stick_fraction = turn.rest_time / turn.period();
    verdict.overshoot = std::max(0.0, turn.position_max) * std::abs(joint.k_p / joint.steady_friction);
    if (end.outcome != Outcome::irregular) verdict.period = turn.period();
}

}  // namespace

double natural_time(const DelayedJoint& joint)
{
    return std::sqrt(joint.inertia / std::abs(joint.k_p));
}

double default_size(const DelayedJoint& joint, DisturbanceKind kind)
{
    switch (kind) {
        case DisturbanceKind::velocity:
            return linear_size * joint.V0;
        case DisturbanceKind::impulse:
            return linear_size * joint.V0 * joint.inertia;
        case DisturbanceKind::start:
            return 1 - linear_size;
        default:
            return linear_size * joint.V0 * natural_time(joint);
    }
}

PositionAndSpeed disturbed(const DelayedJoint& joint, DisturbanceKind kind, double size)
{
    switch (kind) {
        case DisturbanceKind::velocity:
            return {0, joint.V0 + size};
        case DisturbanceKind::impulse:
            return {0, joint.V0 + size / joint.inertia};
        case DisturbanceKind::start:
            return {(joint.holding_force(0) - joint.static_force()) / joint.k_p, 0};
        default:
            return {size, joint.V0};
    }
}

NonlinearVerdict delayed_verdict(const Joint& joint, const DelayedJoint& delayed, const NonlinearOptions& options)
{
    NonlinearVerdict verdict;
    verdict.disturbance = options.disturbance;
    verdict.path = DecisionPath::cvode;
    const auto kind = options.disturbance.kind;
    if (kind == DisturbanceKind::state || !(delayed.k_p > 0)) {  // no states to disturb; no oscillation to follow
        verdict.outcome = Outcome::undecided;
        verdict.reason = Reason::unsupported;
        verdict.explanation = delayed.k_p > 0 ? "friction that answers late has no states of its own to disturb"
                                              : "diverges: without a positive position gain no spring holds the motion";
        return verdict;
    }
    const bool stated_small = !is_set(options.disturbance.size);
    if (stated_small) verdict.disturbance.size = default_size(delayed, kind);
    const auto linear = linear_verdict(joint).state_variable;
    if (linear.eigenvalues.empty()) {
        verdict.outcome = Outcome::undecided;
        verdict.reason = Reason::unsupported;
        return verdict;
    }
    const auto s = linear.eigenvalues.front();
    verdict.growth_rate = measured_growth(delayed, s, options.rtol);
    const bool measurable = std::abs(verdict.growth_rate) > measurable_growth * std::abs(s);
    const bool decays = measurable ? verdict.growth_rate < 0 : linear.stable;

    End stated;
    stated.outcome = Outcome::stable_sliding;
    if (!(stated_small && decays)) {
        // a small disturbance that grows is lifted to a tenth of V_0: its direction is known, its size is not
        const double lift = stated_small && kind != DisturbanceKind::start ? 0.1 / linear_size : 1;
        stated = follow(delayed, disturbed(delayed, kind, lift * verdict.disturbance.size), options);
    }
    verdict.outcome = stated.outcome;
    verdict.reason = stated.reason;
    if (oscillates(stated.outcome)) describe(delayed, stated, verdict);
    if (!decays) {
        verdict.region = NonlinearRegion::stick_slip;
    } else if (oscillates(stated.outcome)) {
        verdict.region = NonlinearRegion::bistable;
    } else if (options.region) {
        const auto large = follow(delayed, disturbed(delayed, DisturbanceKind::start, 0), options);
        if (large.outcome == Outcome::stable_sliding)
            verdict.region = NonlinearRegion::stable;
        else if (oscillates(large.outcome))
            verdict.region = NonlinearRegion::bistable, verdict.reason = large.reason,
            describe(delayed, large, verdict);
        else
            verdict.reason = large.reason;
    }
    return verdict;
}

}  // namespace stickslip
