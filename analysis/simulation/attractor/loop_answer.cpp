// The answer of a loop that is followed tick by tick, as a nonlinear verdict.
#include "analysis/simulation/attractor/loop_answer.h"

#include <cmath>

namespace stickslip {

LoopQuestion loop_question(const NonlinearOptions& options)
{
    LoopQuestion question;
    question.disturbance = options.disturbance;
    question.rtol = options.rtol;
    question.turn_limit = options.turn_limit;
    question.region = options.region;
    question.effort = options.effort;
    return question;
}

NonlinearVerdict verdict_of(const LoopVerdict& found, const NonlinearOptions& options)
{
    NonlinearVerdict verdict;
    verdict.disturbance = options.disturbance;
    if (std::isfinite(found.size)) verdict.disturbance.size = found.size;
    verdict.outcome = found.reason == Reason::linear_only ? Outcome::linear_only : found.stated.outcome();
    verdict.region = found.region;
    verdict.noise_suffices = found.noise_suffices;
    verdict.growth_rate = found.growth_rate;
    // sliding that only the encoder or its noise disturbs has no cycle
    const bool slides = found.stated.kind == LoopEnd::Kind::steady && found.region != NonlinearRegion::bistable;
    verdict.amplitude = slides ? missing : found.cycle.amplitude;
    verdict.jitter = slides ? found.stated.amplitude : found.cycle.jitter;
    verdict.velocity_min = found.cycle.velocity_min;
    verdict.velocity_max = found.cycle.velocity_max;
    verdict.period = found.cycle.period;
    verdict.stick_fraction = found.cycle.stick_fraction;
    verdict.repeats = found.cycle.repeats;
    const bool ended = verdict.outcome != Outcome::undecided && verdict.outcome != Outcome::solver_failure;
    if (ended) verdict.overshoot = found.overshoot;  // what a motion reaches depends on where it was stopped
    verdict.path = DecisionPath::ticks;
    verdict.reason = found.reason;
    verdict.detail = found.detail;
    verdict.searched_from = found.searched_from;
    if (std::isnan(verdict.growth_rate))
        verdict.growth_missing =
            found.growth_missing == Detail::none ? Detail::growth_unmeasured : found.growth_missing;
    if (options.bifurcation && verdict.region == NonlinearRegion::bistable)
        verdict.fold_missing = Detail::fold_of_ideal_loop;
    return verdict;
}

}  // namespace stickslip
