#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>

#include "analysis/simulation/delay.h"
#include "analysis/simulation/nonlinear.h"
#include "analysis/stability/verdict.h"

namespace stickslip {
namespace {

constexpr double linear_size = 1e-6;        ///< of V_0: the disturbance whose growth is measured
constexpr double settled_size = 1e-5;       ///< of V_0: steady sliding again
constexpr double still_linear = 1e-2;       ///< of V_0: where the measurement of growth ends at the latest
constexpr double finest_tolerance = 1e-12;  ///< of V_0, beside forces of some N whose rounding enters
constexpr double faded = 1e-9;              ///< of V_0: where it ends if the motion decays
constexpr double sample_distance = 0.7;     ///< per √(m/k_p)
constexpr int most_samples = 100;
constexpr double closed = 1e-6;  ///< relative gap of a closed orbit
constexpr double turn_limit_in_turns = 1e3;

/// Re s of the slowest mode from four samples at equal distances: what one pair of modes does obeys
/// x_{n+2} = a x_{n+1} + b x_n, whose characteristic roots are e^{sΔ} (Prony).
double rate_of_samples(const std::deque<double>& x, double distance)
{
    const double det = x[1] * x[1] - x[0] * x[2];
    const double a = (x[2] * x[1] - x[3] * x[0]) / det, b = (x[1] * x[3] - x[2] * x[2]) / det;
    const auto root = std::sqrt(std::complex<double>(a * a / 4 + b));
    return std::log(std::max(std::abs(a / 2 + root), std::abs(a / 2 - root))) / distance;
}

/// Growth per time of the slowest mode, when faster ones are gone and before the motion is large.
double measured_growth(const DelayedJoint& joint, double rtol)
{
    const double unit = joint.V0 * natural_time(joint), distance = sample_distance * natural_time(joint);
    DelayMotion motion(joint, std::max(rtol * linear_size, finest_tolerance));
    motion.start(linear_size * unit, joint.V0);
    std::deque<double> samples;
    for (int i = 1; i <= most_samples; ++i) {
        Turn turn;
        while (motion.time() < i * distance) {
            turn = motion.turn(i * distance, 0);
            if (turn.end == Turn::End::failure || turn.end == Turn::End::held) return missing;
        }
        const double size = std::abs(turn.state[0]) / unit;
        if (size > still_linear || (samples.size() == 4 && size < faded && std::abs(samples.back()) < faded * unit))
            break;
        samples.push_back(turn.state[0]);
        if (samples.size() > 4) samples.pop_front();
    }
    return samples.size() == 4 ? rate_of_samples(samples, distance) : missing;
}

struct End {
    Outcome outcome = Outcome::undecided;
    Reason reason = Reason::none;
    Turn turn;
};

End follow(const DelayedJoint& joint, PositionAndSpeed from, const NonlinearOptions& options)
{
    DelayMotion motion(joint, options.rtol);
    motion.start(from.x, from.V);
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
        return verdict;
    }
    const bool stated_small = !is_set(options.disturbance.size);
    if (stated_small) verdict.disturbance.size = default_size(delayed, kind);
    verdict.growth_rate = measured_growth(delayed, options.rtol);
    const bool stable = linear_verdict(joint).state_variable.stable;
    const bool decays = std::isnan(verdict.growth_rate) || verdict.growth_rate == 0 ? stable : verdict.growth_rate < 0;

    End stated;
    stated.outcome = Outcome::stable_sliding;
    if (!(stated_small && decays)) {
        // a small disturbance that grows is lifted to a tenth of V_0: its direction is known, its size is not
        const double lift = stated_small && kind != DisturbanceKind::start ? 0.1 / linear_size : 1;
        stated = follow(delayed, disturbed(delayed, kind, lift * verdict.disturbance.size), options);
    }
    verdict.outcome = stated.outcome;
    verdict.reason = stated.reason;
    if (oscillates(stated.outcome)) describe(delayed, stated.turn, verdict);
    if (!decays) {
        verdict.region = NonlinearRegion::stick_slip;
    } else if (oscillates(stated.outcome)) {
        verdict.region = NonlinearRegion::bistable;
    } else if (options.region) {
        const auto large = follow(delayed, disturbed(delayed, DisturbanceKind::start, 0), options);
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
