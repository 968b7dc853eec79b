#include "analysis/simulation/set_point/set_point.h"

#include "analysis/base/require_valid.h"
#include "analysis/joint/gains.h"
#include "analysis/simulation/set_point/hunting_search.h"
#include "analysis/simulation/set_point/presliding.h"
#include "analysis/simulation/set_point/slip.h"
#include "analysis/simulation/set_point/unused_at_rest.h"

namespace stickslip {
namespace {

/// Coulomb, static and viscous friction of a law that has them; the law's forces are multiplied by the normal load.
struct RestingFriction {
    DryFriction dry;
    double viscous = 0;
    double presliding = 0;  ///< how far bristles give way up to F_s; 0: true rest
    bool flat = false;      ///< F_c at every speed: closed form
};

struct FrictionOrReason {
    RestingFriction friction;
    SetPointReason reason = SetPointReason::none;
};

FrictionOrReason resting_friction(const Friction& friction)
{
    const double n = friction.normal_load;
    const auto bristles = [&](double coulomb, double breakaway, double viscous, double stiffness) {
        return RestingFriction{{n * coulomb, n * breakaway}, n * viscous, breakaway / stiffness, false};
    };
    if (friction.has_bristle() || friction.has_memory() || friction.has_lag() || friction.level_moves() ||
        friction.asymmetry.viscous != 0)
        return {{}, SetPointReason::friction_term};
    if (const auto* law = std::get_if<CoulombViscous>(&friction.law))
        return {{{n * law->coulomb, n * law->coulomb}, n * law->viscous, 0, true}};
    if (const auto* law = std::get_if<KineticStatic>(&friction.law))
        return {{{n * law->kinetic, n * law->breakaway}, 0, 0, true}};
    if (const auto* law = std::get_if<Stribeck>(&friction.law)) {
        // below one the curve leaves rest with a vertical tangent, which the solver does not step over
        if (law->c2 > 0 && law->c4 < 1) return {{}, SetPointReason::law_without_motion};
        return {{{n * law->c0, n * (law->c0 + law->c2)}, n * law->c1, 0, law->c2 == 0}};
    }
    if (const auto* law = std::get_if<LuGre>(&friction.law))
        return {bristles(law->coulomb, law->breakaway, law->sigma2, law->sigma0)};
    if (const auto* law = std::get_if<Dahl>(&friction.law))
        return {bristles(law->coulomb, law->coulomb, 0, law->sigma0)};
    return {{},
            info(friction.law).needs_motion ? SetPointReason::law_needs_motion : SetPointReason::law_without_motion};
}

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

/// Whether the command acts later than the error that it answers.
bool delayed(const Joint& joint)
{
    return is_set(joint.control.period) || joint.control.delay > 0 || joint.sensor.delay > 0 || joint.actuator.lag > 0;
}

/// Where the side of the error alone moves the mass, it can rest in one point only, and a loop that is late passes
/// that point each time: I. Boiko, Discontinuous Control Systems, 2009. An exact loop comes to rest there.
bool pushes_itself(const Joint& joint, const Regulator& regulator, double held)
{
    const auto& push = regulator.push;
    return push.jumps() && push.coulomb > held && regulator.dead_zone == 0 && delayed(joint);
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

SetPoint without_integral(const Joint& joint, const Regulator& regulator, const DryFriction& dry, double load)
{
    if (regulator.k_i < 0 || !(regulator.k_p > 0))
        return rests(SetPointReason::loop_unstable, missing, SetPointMethod::closed_form);
    if (load > regulator.effort_limit) return undecided(SetPointReason::loaded);
    if (regulator.dither > 0) return under_dither(regulator, dry, load);
    const bool breaks = dry.breakaway + load <= regulator.effort_limit;
    const double band = breaks ? regulator.error_holding(dry.breakaway + load) + regulator.dead_zone : infinity;
    if (breaks && regulator.push.by_velocity())
        return hunting_without_integral(StopToStop(regulator, joint.friction), band);
    return rests(SetPointReason::no_integral_action, band, SetPointMethod::closed_form);
}

/// What pulls the joint at rest to one side, in effort.
double pull(const Joint& joint)
{
    return std::abs(joint.load.constant - joint.friction.normal_load * joint.friction.asymmetry.coulomb);
}

/// With a loop that integrates: the limits leave `taken` less to it than they are.
SetPoint with_integral(const Joint& joint, const SetPointQuestion& question, Regulator regulator,
                       const RestingFriction& friction, double taken)
{
    const PidMass mass{regulator.inertia, regulator.k_v + regulator.drag + friction.viscous, regulator.k_p,
                       regulator.k_i};
    if (!mass.stable()) return rests(SetPointReason::loop_unstable, missing, SetPointMethod::closed_form);
    if (friction.flat && regulator.linear()) return in_closed_form(mass, friction.dry);
    regulator.integral_limit -= taken;
    regulator.effort_limit -= taken;
    const auto cycle = hunting_cycle(mass, friction.dry);
    const double natural = cycle.found ? cycle.amplitude : friction.dry.breakaway / regulator.k_p;
    if (friction.presliding > 0) return with_bristles(regulator, joint.friction, friction, natural);
    auto s = hunting_by_events(StopToStop(regulator, joint.friction), natural, regulator.dead_zone,
                               question.starts_per_decade);
    if (s.hunting == Hunting::yes && friction.flat) s.reason = SetPointReason::static_above_coulomb;
    return s;
}

/// The integral carries the load, which takes as much of every limit on one side as it adds on the other. An answer is
/// one where both sides agree.
SetPoint carrying(const Joint& joint, const SetPointQuestion& question, const Regulator& regulator,
                  const RestingFriction& friction)
{
    constexpr double same = 1e-6;
    const double load = pull(joint);
    const bool limited = regulator.integral_limit < infinity || regulator.effort_limit < infinity;
    const auto near = with_integral(joint, question, regulator, friction, limited ? load : 0);
    if (!limited || load == 0) return near;
    const auto far = with_integral(joint, question, regulator, friction, -load);
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
    if (regulator.dither > 0 && (friction.presliding > 0 || regulator.k_i > 0))
        return undecided(SetPointReason::dithered);
    if (pushes_itself(joint, regulator, friction.dry.breakaway + pull(joint)))
        return pushed_about(SetPointReason::push_breaks_friction);
    if (friction.presliding > 0 && regulator.push.fed_back()) return undecided(SetPointReason::bristles_compensated);
    if (!(regulator.k_i > 0)) return without_integral(joint, regulator, friction.dry, pull(joint));
    return carrying(joint, question, regulator, friction);
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
