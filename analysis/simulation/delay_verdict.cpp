#include <algorithm>
#include <cmath>

#include "analysis/simulation/delay.h"
#include "analysis/simulation/nonlinear.h"
#include "analysis/stability/verdict.h"

namespace stickslip {
namespace {

constexpr double linear_size = 1e-6;        ///< of V_0: the disturbance whose growth is measured
constexpr double settled_size = 1e-5;       ///< of V_0: steady sliding again
constexpr double still_linear = 1e-2;       ///< of V_0: where the measurement of growth ends at the latest
constexpr double finest_tolerance = 1e-12;  ///< of V_0, beside forces of some N whose rounding enters
constexpr int settling_turns = 4, measuring_turns = 10;
constexpr double closed = 1e-6;  ///< relative gap of a closed orbit
constexpr double turn_limit_in_turns = 1e3;

double natural_time(const DelayedJoint& joint)
{
    return std::sqrt(joint.inertia / std::abs(joint.k_p));
}

/// Growth per time of the slowest mode: largest positions of later turns, when faster modes are gone.
double measured_growth(const DelayedJoint& joint, double rtol)
{
    const double unit = joint.V0 * natural_time(joint);
    DelayMotion motion(joint, std::max(rtol * linear_size, finest_tolerance));
    motion.start(linear_size * unit, joint.V0);
    double x0 = missing, t0 = 0, growth = missing;
    for (int i = 0; i < settling_turns + measuring_turns; ++i) {
        const auto turn = motion.turn(motion.time() + turn_limit_in_turns * natural_time(joint), 0);
        if (turn.end != Turn::End::crossing || std::abs(turn.state[0]) > still_linear * unit) return growth;
        if (i == settling_turns - 1) x0 = turn.state[0], t0 = turn.t1;
        if (i >= settling_turns) growth = std::log(turn.state[0] / x0) / (turn.t1 - t0);
    }
    return growth;
}

struct End {
    Outcome outcome = Outcome::undecided;
    Reason reason = Reason::none;
    Turn turn;
};

End follow(const DelayedJoint& joint, double x, double V, const NonlinearOptions& options)
{
    DelayMotion motion(joint, options.rtol);
    motion.start(x, V);
    End end;
    double last = missing, last_gap = missing;
    for (int i = 0; i < options.turn_limit; ++i) {
        end.turn = motion.turn(motion.time() + turn_limit_in_turns * natural_time(joint), settled_size);
        const auto& turn = end.turn;
        if (turn.end == Turn::End::settled) {
            end.outcome = Outcome::stable_sliding;
            return end;
        }
        if (turn.end != Turn::End::crossing) {
            end.outcome = turn.reversed ? Outcome::reversal : Outcome::undecided;
            end.reason =
                turn.end == Turn::End::failure && !turn.reversed ? Reason::solver_failed : Reason::not_converged;
            return end;
        }
        const double gap = std::abs(turn.state[0] - last), ratio = std::min(gap / last_gap, 0.999);
        const bool repeats = gap / (1 - ratio) < closed * std::abs(turn.state[0]);
        if (repeats && i > 3) {
            end.outcome = turn.rest_time > 0 ? Outcome::stick_slip : Outcome::limit_cycle;
            return end;
        }
        last = turn.state[0];
        last_gap = gap;
    }
    end.reason = Reason::not_converged;
    return end;
}

bool oscillates(Outcome outcome)
{
    return outcome == Outcome::stick_slip || outcome == Outcome::limit_cycle || outcome == Outcome::reversal;
}

void describe(const DelayedJoint& joint, const Turn& turn, NonlinearVerdict& verdict)
{
    verdict.period = turn.period();
    verdict.amplitude = 0.5 * (turn.position_max - turn.position_min);
    verdict.velocity_min = turn.velocity_min;
    verdict.velocity_max = turn.velocity_max;
    verdict.stick_fraction = turn.rest_time / turn.period();
    verdict.overshoot = std::max(0.0, turn.position_max) * std::abs(joint.k_p / joint.steady_friction);
}

}  // namespace

NonlinearVerdict delayed_verdict(const Joint& joint, const DelayedJoint& delayed, const NonlinearOptions& options)
{
    NonlinearVerdict verdict;
    verdict.disturbance = options.disturbance;
    verdict.path = DecisionPath::cvode;
    const auto kind = options.disturbance.kind;
    if (kind == DisturbanceKind::state || !(delayed.k_p > 0)) {  // no states to disturb; no oscillation to follow
        verdict.outcome = Outcome::undecided;
        verdict.reason = Reason::unsupported;
        return verdict;
    }
    const bool stated_small = !is_set(options.disturbance.size);
    const bool of_speed = kind == DisturbanceKind::velocity || kind == DisturbanceKind::impulse;
    if (stated_small) verdict.disturbance.size = linear_size * delayed.V0 * (of_speed ? 1 : natural_time(delayed));
    verdict.growth_rate = measured_growth(delayed, options.rtol);
    const bool stable = linear_verdict(joint).state_variable.stable;
    const bool decays = std::isnan(verdict.growth_rate) || verdict.growth_rate == 0 ? stable : verdict.growth_rate < 0;

    const double at_rest = (delayed.holding_force(0) - delayed.static_force()) / delayed.k_p;
    const double size = verdict.disturbance.size;
    const double speed = kind == DisturbanceKind::impulse ? size / delayed.inertia : size;
    End stated;
    stated.outcome = Outcome::stable_sliding;
    if (!(stated_small && decays)) {
        // a small disturbance that grows is lifted to a tenth of V_0: its direction is known, its size is not
        const double lift = stated_small ? 0.1 / linear_size : 1;
        if (kind == DisturbanceKind::start)
            stated = follow(delayed, at_rest, 0, options);
        else if (of_speed)
            stated = follow(delayed, 0, delayed.V0 + lift * speed, options);
        else
            stated = follow(delayed, lift * size, delayed.V0, options);
    }
    verdict.outcome = stated.outcome;
    verdict.reason = stated.reason;
    if (oscillates(stated.outcome)) describe(delayed, stated.turn, verdict);
    if (!decays) {
        verdict.region = NonlinearRegion::stick_slip;
    } else if (oscillates(stated.outcome)) {
        verdict.region = NonlinearRegion::bistable;
    } else if (options.region) {
        const auto large = follow(delayed, at_rest, 0, options);
        if (large.outcome == Outcome::stable_sliding)
            verdict.region = NonlinearRegion::stable;
        else if (oscillates(large.outcome))
            verdict.region = NonlinearRegion::bistable, describe(delayed, large.turn, verdict);
        else
            verdict.reason = large.reason;
    }
    return verdict;
}

}  // namespace stickslip
