#include "analysis/simulation/set_point/set_point.h"

#include "analysis/base/require_valid.h"
#include "analysis/joint/gains.h"
#include "analysis/simulation/set_point/hunting_search.h"
#include "analysis/simulation/set_point/presliding.h"
#include "analysis/simulation/set_point/resting_friction.h"
#include "analysis/simulation/set_point/sampled_hunting.h"
#include "analysis/simulation/set_point/set_point_load.h"
#include "analysis/simulation/set_point/sliding_loop.h"
#include "analysis/simulation/set_point/slip.h"
#include "analysis/simulation/set_point/unused_at_rest.h"

namespace stickslip {
namespace {

SetPoint undecided(SetPointReason reason)
{
    SetPoint s;
    s.reason = reason;
    return s;
}

SetPoint rests(SetPointReason reason, double error, SetPointMethod method)
{
    SetPoint s;
    s.hunting = Hunting::no;
    s.reason = reason;
    s.rest_error = error;
    s.method = method;
    return s;
}

SetPoint in_closed_form(const PidMass& mass, const DryFriction& dry)
{
    if (dry.breakaway == dry.coulomb) {
        auto s = rests(SetPointReason::static_is_coulomb, 0, SetPointMethod::closed_form);
        s.multiplier = settling_multiplier(mass);
        return s;
    }
    const auto cycle = hunting_cycle(mass, dry);
    // no stop at the end of the slip: such a cycle was never met, and has no form here
    if (!cycle.found || cycle.stick_time < 0) return undecided(SetPointReason::not_converged);
    SetPoint s;
    s.hunting = Hunting::yes;
    s.reason = SetPointReason::static_above_coulomb;
    s.method = SetPointMethod::closed_form;
    s.amplitude = cycle.amplitude;
    s.slip_time = cycle.slip_time;
    s.stick_time = cycle.stick_time;
    s.period = cycle.period();
    s.multiplier = cycle.multiplier;
    return s;
}

SetPoint with_bristles(const Regulator& regulator, const Friction& law, const RestingFriction& friction, double natural)
{
    // from beyond the cycle that the same levels would have with true rest
    const double start = std::max(2 * natural, 10 * friction.presliding);
    const auto end = follow_presliding(regulator, law, start, friction.dry.breakaway, friction.presliding);
    SetPoint s;
    s.method = SetPointMethod::presliding;
    switch (end.end) {
        case Presliding::End::settles:
            return rests(SetPointReason::slips_shrink, regulator.dead_zone, SetPointMethod::presliding);
        case Presliding::End::runaway:
            return rests(SetPointReason::loop_unstable, missing, SetPointMethod::presliding);
        case Presliding::End::failure:
            s.reason = SetPointReason::not_converged;
            return s;
        case Presliding::End::cycle:
            break;
    }
    s.hunting = Hunting::yes;
    s.reason = SetPointReason::falling_friction;
    s.amplitude = end.amplitude;
    s.slip_time = end.slip_time;
    s.stick_time = end.stick_time;
    s.period = 2 * (end.slip_time + end.stick_time);
    s.multiplier = end.multiplier;
    s.rests_nearby = true;
    return s;
}

/// Where the side of the error alone moves the mass, it can rest in one point only, and a loop that is late passes
/// that point each time: I. Boiko, Discontinuous Control Systems, 2009. An exact loop comes to rest there.
bool pushes_itself(const Joint& joint, const Regulator& regulator, double held)
{
    const auto& push = regulator.push;
    return push.jumps() && push.coulomb > held && regulator.dead_zone == 0 && acts_late(joint);
}

SetPoint pushed_about(SetPointReason reason)
{
    SetPoint s;
    s.hunting = Hunting::yes;
    s.reason = reason;
    s.method = SetPointMethod::closed_form;
    return s;
}

/// See set_point.h; a push that is fed back beside it has no such energy. `load`: what the loop carries besides.
SetPoint under_dither(const Regulator& regulator, const DryFriction& dry, double load)
{
    if (regulator.push.fed_back() || regulator.dither >= dry.coulomb) return undecided(SetPointReason::dithered);
    const bool breaks = dry.breakaway + load <= regulator.effort_limit;
    const double band = (dry.breakaway + load - regulator.dither) / regulator.k_p + regulator.dead_zone;
    return rests(SetPointReason::dither_narrows, breaks ? band : infinity, SetPointMethod::closed_form);
}

SetPoint without_integral(const Joint& joint, const Regulator& regulator, const RestingFriction& friction,
                          const RestingPull& pull)
{
    const auto& dry = friction.dry;
    const double load = std::abs(pull.on_feedback), held = std::abs(pull.on_limits);
    if (regulator.k_i < 0 || !(regulator.k_p > 0))
        return rests(SetPointReason::loop_unstable, missing, SetPointMethod::closed_form);
    if (held > regulator.effort_limit) return undecided(SetPointReason::loaded);
    const bool breaks = dry.breakaway + held <= regulator.effort_limit;
    if (regulator.dither > 0) return under_dither(regulator, dry, load);
    if (is_simulated(joint)) {
        const auto s = resting_by_simulation(SampledStops(joint, regulator, friction.viscous));
        if (s.hunting != Hunting::no || s.diverges() || breaks) return s;
        return rests(SetPointReason::no_integral_action, infinity, SetPointMethod::simulated);
    }
    const double band = breaks ? regulator.error_holding(dry.breakaway + load) + regulator.dead_zone : infinity;
    if (breaks && regulator.push.by_velocity())
        return hunting_without_integral(StopToStop(regulator, joint.friction), band);
    return rests(SetPointReason::no_integral_action, band, SetPointMethod::closed_form);
}

SetPoint simulated(const Joint& joint, const SetPointQuestion& question, const Regulator& regulator,
                   const RestingFriction& friction, double natural)
{
    const bool unstable = !(sliding_growth(joint, friction.viscous) < 0);
    auto s = hunting_by_simulation(SampledStops(joint, regulator, friction.viscous), natural,
                                   {question.starts_per_decade, unstable, question.by_start});
    const bool equal = friction.flat && friction.dry.breakaway == friction.dry.coulomb;
    if (s.hunting == Hunting::yes && s.reason == SetPointReason::falling_friction && friction.flat && !equal)
        s.reason = SetPointReason::static_above_coulomb;
    if (s.hunting == Hunting::no && s.reason == SetPointReason::slips_shrink && equal)
        s.reason = SetPointReason::static_is_coulomb;
    return s;
}

/// With a loop that integrates: the load takes that much of the limits.
SetPoint with_integral(const Joint& joint, const SetPointQuestion& question, Regulator regulator,
                       const RestingFriction& friction, const RestingPull& taken)
{
    const PidMass mass{regulator.inertia, regulator.k_v + regulator.drag + friction.viscous, regulator.k_p,
                       regulator.k_i};
    const auto cycle_or_spring = [&] {
        const auto cycle = hunting_cycle(mass, friction.dry);
        return cycle.found ? cycle.amplitude : friction.dry.breakaway / regulator.k_p;
    };
    if (is_simulated(joint)) return simulated(joint, question, regulator, friction, cycle_or_spring());
    const bool stable = mass.stable();
    if (stable && friction.flat && regulator.linear()) return in_closed_form(mass, friction.dry);
    regulator.integral_limit -= taken.on_feedback;
    regulator.effort_limit -= taken.on_limits;
    const double natural = cycle_or_spring();
    if (!stable && (friction.presliding > 0 || !question.by_start))
        return rests(SetPointReason::loop_unstable, missing, SetPointMethod::closed_form);
    if (friction.presliding > 0) return with_bristles(regulator, joint.friction, friction, natural);
    auto s = hunting_by_events(StopToStop(regulator, joint.friction), natural, regulator.dead_zone,
                               {question.starts_per_decade, !stable, question.by_start});
    if (s.reason == SetPointReason::falling_friction && friction.flat) s.reason = SetPointReason::static_above_coulomb;
    return s;
}

/// The integral carries the load, which takes as much of every limit on one side as it adds on the other. An answer is
/// one where both sides agree.
SetPoint carrying(const Joint& joint, const SetPointQuestion& question, const Regulator& regulator,
                  const RestingFriction& friction, const RestingPull& pull)
{
    constexpr double same = 1e-6;
    const double way = std::copysign(1.0, pull.on_limits);
    const RestingPull load{way * pull.on_limits, way * pull.on_feedback};
    const bool limited = regulator.integral_limit < infinity || regulator.effort_limit < infinity;
    const auto near = with_integral(joint, question, regulator, friction, limited ? load : RestingPull{});
    if (!limited || is_simulated(joint) || (load.on_limits == 0 && load.on_feedback == 0)) return near;
    const auto far = with_integral(joint, question, regulator, friction, {-load.on_limits, -load.on_feedback});
    const bool hunts = near.hunting == Hunting::yes;
    if (near.hunting != far.hunting || near.diverges() != far.diverges() ||
        (hunts && !(std::abs(near.amplitude - far.amplitude) <= same * far.amplitude)))
        return undecided(SetPointReason::loaded);
    return near;
}

SetPoint decided(const Joint& joint, const SetPointQuestion& question)
{
    if (joint.control.kind == ControlKind::force) return undecided(SetPointReason::force_control);
    if (joint.mechanism.model != Model::single_mass) return undecided(SetPointReason::several_bodies);
    const auto [friction, reason] = resting_friction(joint.friction);
    if (reason != SetPointReason::none) return undecided(reason);
    const auto regulator = regulator_of(joint);
    if (matters_at_rest(joint, regulator.per_signal)) return undecided(SetPointReason::left_out);
    const auto pull = pull_at(joint, 0, regulator.per_signal);
    if (std::abs(pull.on_limits) - friction.dry.breakaway > regulator.effort_limit)
        return rests(SetPointReason::load_beyond_limits, missing, SetPointMethod::closed_form);
    const bool integrates = regulator.k_i > 0, simulated = is_simulated(joint);
    if (simulated && !(integrates && question.by_start) && !(sliding_growth(joint, friction.viscous) < 0))
        return rests(SetPointReason::loop_unstable, missing, SetPointMethod::closed_form);
    const bool late = joint.dead_time() > 0 || joint.actuator.lag > 0;
    if (regulator.dither > 0 && (friction.presliding > 0 || integrates || (simulated && late)))
        return undecided(SetPointReason::dithered);
    if (pushes_itself(joint, regulator, friction.dry.breakaway + std::abs(pull.on_feedback)))
        return pushed_about(SetPointReason::push_breaks_friction);
    if (friction.presliding > 0 && regulator.push.fed_back()) return undecided(SetPointReason::bristles_compensated);
    if (friction.presliding > 0 && simulated) return undecided(SetPointReason::loop_not_simulated);
    if (!integrates) return without_integral(joint, regulator, friction, pull);
    return carrying(joint, question, regulator, friction, pull);
}

}  // namespace

bool integrates(const Joint& joint)
{
    return gains_of(joint.control).k_i != 0;
}

std::string SetPointQuestion::problem() const
{
    return problem_unless(starts_per_decade >= 1, "starts_per_decade", starts_per_decade, "at least 1");
}

SetPoint set_point(const Joint& joint, const SetPointQuestion& question)
{
    require_valid(question);
    SetPoint s = decided(joint, question);
    const auto friction = resting_friction(joint.friction);
    if (friction.reason == SetPointReason::none) s.own_level = friction.friction.dry.breakaway;
    if (const auto push = regulator_of(joint).push; push.fed_back()) s.compensation = push.coulomb;
    s.not_used = unused_at_rest(joint);
    return s;
}

}  // namespace stickslip
