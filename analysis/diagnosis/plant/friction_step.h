// Friction inside one time step: how hard a body resists, and what is left of its velocity. For packs of bodies
// (simulation/lanes/pack.h), a single one being a pack of one: each has its numbers, all have the same terms.
// In one file: one time step of friction, whose level, memory and bristles are parts of one balance.
#pragma once
#include "analysis/diagnosis/plant/plant.h"
#include "analysis/friction/memory_step.h"
#include "analysis/simulation/lanes/sine.h"

#include <utility>

namespace stickslip::gap {

/// What the frictions of a pack have in common.
struct Terms {
    bool stribeck = false, asymmetric = false, loaded = false, geared = false, ripple = false, second_ripple = false,
         drifts = false, bristles = false;
    bool remembers = false, ageing = false, lags = false, late = false, plain = false, one_slope = false;
    int exponent = 0;  ///< of a Stribeck peak: 1 or 2; 0 for others
    bool operator==(const Terms&) const = default;
};

/// Terms that are told as the program runs, and terms that are known as it is built: then what a time step does not
/// need is not there.
struct ToldTerms {
    Terms has;
    void tell(const Terms& terms) { has = terms; }
};
template <Terms terms>
struct KnownTerms {
    static constexpr Terms has = terms;
    void tell(const Terms&) {}
};

inline Terms terms_of(const FlatFriction& r)
{
    Terms t;
    t.stribeck = r.stribeck != 0, t.ripple = r.ripple != 0, t.second_ripple = r.second_ripple != 0,
    t.drifts = r.drift != 0;
    t.asymmetric = r.asymmetric_coulomb != 0 || r.asymmetric_viscous != 0, t.loaded = r.load_coefficient != 0;
    t.geared = r.geared();
    t.bristles = r.bristle_stiffness > 0;
    t.remembers = r.remembers(), t.ageing = r.ageing && t.remembers, t.lags = r.lag > 0, t.late = r.late();
    t.plain = r.plain();
    // one level and one slope, in both directions and at all times
    t.one_slope = t.plain && !t.asymmetric && r.bristle_stiffness == 0 && r.lag == 0;
    t.exponent = t.stribeck && (r.exponent == 1 || r.exponent == 2) ? static_cast<int>(r.exponent) : 0;
    return t;
}

/// The frictions of a pack of bodies.
template <class P, class HasTerms = ToldTerms>
struct FrictionPack : FlatFrictionOf<P>, HasTerms {
};

/// What one body's friction remembers between steps.
template <class P>
struct FrictionState {
    P bristle = 0;  ///< deflection z
    P theta = 0;    ///< memory state
    P speed = 0;    ///< lagged speed, for a level that follows the velocity late
    P force = 0;    ///< of a whole curve that is followed late
    P gained = 0;   ///< velocity that `friction_step` gave in the last step: predicts that in mid-step
};

/// Where a step happens and what passes through, as far as friction asks.
template <class P>
struct Surroundings {
    P position, transmitted;
    P load = 0, net = 0;  ///< a single mass: what the load resists, and all that pushes but friction
};

template <class P>
P exp_of(const P& x)
{
    return lanes::exponential(x).value;
}

/// The part of a drift that has come by this time. It is slow: a tick holds it.
template <class P, class T>
P drifted(const FrictionPack<P, T>& r, const P& t)
{
    return r.drift * -lanes::exponential(-t / r.drift_time).minus_one;
}

/// ln(|v|/V* + floor), what the memory goes by.
template <class P, class T>
P logarithm_of(const P& speed, const FrictionPack<P, T>& r)
{
    return lanes::logarithm(speed * r.per_V_star + memory_floor);
}

/// The Stribeck peak's height at this speed.
template <class P, class T>
P peak(const FrictionPack<P, T>& r, const P& speed)
{
    constexpr double tiny = 1e-300;  // numerical: whose powers vanish beside one
    const P u = speed / r.stribeck_velocity;
    const P power = r.has.exponent == 2   ? u * u
                    : r.has.exponent == 1 ? u
                                          : exp_of(r.exponent * lanes::logarithm(max(u, P(tiny))));
    return r.stribeck * exp_of(-power);
}

/// What the law resists in steady sliding, in both directions.
template <class P, class T>
P steady(const FrictionPack<P, T>& r, const P& speed)
{
    const P level = r.has.stribeck ? r.coulomb + peak(r, speed) : r.coulomb;
    return level + r.viscous * speed;
}

/// Slope of the friction with the speed of this instant in this direction.
template <class P, class T>
P viscous(const FrictionPack<P, T>& r, const P& direction)
{
    const P slope = r.has.late ? P(0.0) : r.viscous;
    return r.has.asymmetric ? slope + direction * r.asymmetric_viscous : slope;
}

/// The resisting force apart from viscous friction that follows the speed at once, never negative, for motion in
/// `direction`.
template <class P, class T>
P resistance(const FrictionPack<P, T>& r, const FrictionState<P>& s, const P& speed, const P& direction,
             const Surroundings<P>& at)
{
    P level = r.coulomb;
    if (r.has.plain) return max(level, P(0.0));
    if (r.has.late) level = s.force;
    if (r.has.stribeck && !r.has.late) level = level + peak(r, r.has.lags ? s.speed : speed);
    if (r.has.asymmetric) level = level + direction * r.asymmetric_coulomb;
    if (r.has.loaded) level = level + r.load_coefficient * abs(at.transmitted);
    if (r.has.ripple) level = level + r.ripple * sine(r.ripple_periods * at.position + r.ripple_phase);
    if (r.has.second_ripple)
        level = level + r.second_ripple * sine(2.0 * r.ripple_periods * at.position + r.second_phase);
    if (r.has.remembers) level = level + (r.A * logarithm_of(speed, r) + s.theta);
    level = max(level, P(0.0));
    if (r.has.geared)
        level = level + GearLoss::level(r.gear_forward, r.gear_backward, r.gear_beyond, at.load, at.net, direction,
                                        level + viscous(r, direction) * speed);
    return level;
}

/// The memory state after a slip at this mean speed in h, exact for constant speed.
template <class P, class T>
P remembered(const FrictionPack<P, T>& r, const P& theta, const P& speed, const P& h)
{
    const P slip = speed * h * r.per_L;
    const auto exponential = [](const P& x) { return exp_of(x); };
    if (!r.has.ageing) return after_slip(theta, -r.B * logarithm_of(speed, r), slip, exponential);
    const auto logarithm = [](const P& x) { return lanes::logarithm(x); };
    return after_ageing(theta, r.B, r.L, r.V_star, speed, h, slip, exponential, logarithm);
}

/// The level against bodies that leave rest in this step: that of their speed in mid-step, at which a static level has
/// gone.
template <class P, class T>
P leaving_level(const FrictionPack<P, T>& r, const FrictionState<P>& s, const P& level, const P& direction,
                const P& force, const P& mobility, const Surroundings<P>& at)
{
    return resistance(r, s, 0.5 * mobility * max(P(0.0), abs(force) - level), direction, at);
}

/// The state after sliding at this speed for h: exact for constant speed. It is half a step ahead of the velocity, as
/// the next step asks for it in its middle.
template <class P, class T>
void remember(const FrictionPack<P, T>& r, FrictionState<P>& s, const P& speed, const P& h)
{
    if (r.has.late) {
        const P force = steady(r, speed);
        s.force = force + (s.force - force) * exp_of(-h / r.lag);
    } else if (r.has.lags) {
        s.speed = speed + (s.speed - speed) * exp_of(-h / r.lag);
    }
    if (r.has.remembers) s.theta = remembered(r, s.theta, speed, h);
}

/// The state of bodies that have slid at these velocities for long; at rest it is that of sliding at V*, which is what
/// the law's level means.
template <class P, class T>
FrictionState<P> steady_state(const FrictionPack<P, T>& r, const P& v)
{
    FrictionState<P> s;
    const P speed = abs(v), zero(0.0);
    s.speed = speed;
    s.force = steady(r, speed);
    if (r.has.remembers) s.theta = select(zero < speed, -r.B * logarithm_of(speed, r), zero);
    if (r.has.bristles) {
        const P direction = copysign(P(1.0), v), level = resistance(r, s, speed, direction, {zero, zero});
        s.bristle =
            select((zero < speed) & (zero < r.bristle_stiffness), direction * level / r.bristle_stiffness, zero);
    }
    return s;
}

/// What sliding takes at this velocity in this state, transmitted effort and ripple apart; nothing at rest.
template <class P, class T>
P sliding_force(const FrictionPack<P, T>& r, const FrictionState<P>& s, const P& v)
{
    const P zero(0.0), direction = copysign(P(1.0), v), speed = abs(v);
    const P force = direction * (resistance(r, s, speed, direction, {zero, zero}) + viscous(r, direction) * speed);
    return select(zero < speed, force, zero);
}

/// One step of bodies that slide against a given level of friction: everything but velocity and force is divided out,
/// so that a friction that does not change does it once for many steps.
template <class P>
struct SlidingStep {
    P keep = 1, per_force = 0, held = 0;
    SlidingStep() {}
    SlidingStep(const P& level, const P& slope, const P& mobility)
    {
        const P yielding = P(1.0) / (1.0 + 0.5 * mobility * slope);
        keep = (1.0 - 0.5 * mobility * slope) * yielding;
        per_force = mobility * yielding;
        held = per_force * max(level, P(0.0));
    }
    P operator()(const P& v, const P& force) const
    {
        const P free = keep * v + per_force * force;
        return free - max(-held, min(free, held));
    }
};

/// A step of bodies on bristles: ż = v − a z with a = σ0 |v|/level, f = σ0 z + σ1 ż + slope v, of second order. The
/// bristle forgets by 1/(1 + x + x²/2) in place of e^-x, x = a h (Padé (0, 2): it never rings, and sliding keeps its
/// steady deflection), and velocities are those in mid-step. A bristle or slope too stiff for that is taken at the end
/// of the step, which is of first order and does not ring either.
template <class P>
struct BristleStep {
    P keep, per_velocity;            ///< z' = keep z + per_velocity v_m
    P mean_keep, mean_per_velocity;  ///< mean deflection, likewise
    BristleStep(const P& forgets, const P& h)
    {
        keep = P(1.0) / (1.0 + forgets * (1.0 + 0.5 * forgets));
        mean_keep = (1.0 + 0.5 * forgets) * keep;
        per_velocity = h * mean_keep;
        mean_per_velocity = 0.5 * h * (1.0 + forgets) * keep;
    }
    /// Velocity in mid-step and after the step.
    template <class T>
    std::pair<P, P> velocities(const FrictionPack<P, T>& r, const P& z, const P& v, const P& force, const P& slope,
                               const P& mobility, const P& h) const
    {
        const P damping = r.bristle_damping / h;
        const P resists = r.bristle_stiffness * mean_keep * z + damping * (keep - 1.0) * z;
        const P stiff = mobility * (r.bristle_stiffness * mean_per_velocity + damping * per_velocity + slope);
        const P at = select(stiff < P(1.0), P(0.5), P(1.0));  // where in the step the velocity is taken
        const P taken = (v + at * mobility * (force - resists)) / (1.0 + at * stiff);
        return {taken, (taken - (1.0 - at) * v) / at};
    }
};

/// Velocity after a step in which the force other than friction is `force` and inverse inertia times step is
/// `mobility`. Without bristles friction is set-valued at rest: the body stays at rest while |force| is not above the
/// resistance.
template <class P, class T>
P friction_step(const FrictionPack<P, T>& r, FrictionState<P>& s, const P& v, const P& force, const P& mobility,
                const P& h, const Surroundings<P>& at)
{
    const P zero(0.0);
    P next;
    if (r.has.bristles) {
        const P middle = v + 0.5 * s.gained;
        const P direction = copysign(P(1.0), select(middle != zero, middle, force));
        const P level = resistance(r, s, abs(middle), direction, at), slope = viscous(r, direction);
        const auto bends = zero < level;
        const BristleStep<P> step(h * r.bristle_stiffness * abs(middle) / level, h);
        const auto [taken, after] = step.velocities(r, s.bristle, v, force, slope, mobility, h);
        next = after;
        s.bristle = select(bends, step.keep * s.bristle + step.per_velocity * taken, s.bristle);
        if (!every(bends)) next = select(bends, next, SlidingStep<P>(level, slope, mobility)(v, force));
    } else {
        const auto moving = v != zero;
        const P direction = copysign(P(1.0), select(moving, v, force));
        P level = resistance(r, s, max(zero, direction * (v + 0.5 * s.gained)), direction, at);
        if (const auto leaves = ~moving & (level < abs(force)); r.has.stribeck && any(leaves))
            level = select(leaves, leaving_level(r, s, level, direction, force, mobility, at), level);
        next = SlidingStep<P>(level, viscous(r, direction), mobility)(v, force);
    }
    s.gained = next - v;
    remember(r, s, abs(next), h);
    return next;
}

}  // namespace stickslip::gap
