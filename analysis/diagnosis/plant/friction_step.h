// Friction inside one time step: how hard a body resists, and what is left of its velocity.
#pragma once
#include "analysis/diagnosis/plant/plant.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

/// What one body's friction remembers between steps.
struct RubState {
    double bristle = 0;  ///< deflection z
    double theta = 0;    ///< memory state
    double speed = 0;    ///< lagged speed, for a level that follows the velocity late
    double force = 0;    ///< of a whole curve that is followed late
};

/// Added to the speed inside the logarithms of the memory, as a part of V*: what keeps them finite at rest.
inline constexpr double memory_floor = 1e-3;

/// Where a step happens and what passes through, as far as friction asks.
struct Surroundings {
    double position = 0, transmitted = 0;
};

/// The part of a drift that has come by this time. It is slow: a tick holds it.
inline double drifted(const Rubbing& r, double t)
{
    return r.drift == 0 ? 0 : r.drift * -std::expm1(-t / r.drift_time);
}

/// ln(|v|/V* + floor), what the memory goes by.
inline double logarithm_of(double speed, const Rubbing& r)
{
    return std::log(speed * r.per_V_star + memory_floor);
}

/// What the law resists in steady sliding, in both directions.
inline double steady(const Rubbing& r, double speed)
{
    const double u = speed / r.stribeck_velocity;
    const double peak = r.stribeck != 0 ? r.stribeck * std::exp(-std::pow(u, r.exponent)) : 0;
    return r.coulomb + peak + r.viscous * speed;
}

/// The resisting force apart from viscous friction that follows the speed at once, never negative, for motion in
/// `direction`.
inline double resistance(const Rubbing& r, const RubState& s, double speed, double direction, const Surroundings& at)
{
    double level = r.coulomb;
    if (r.plain()) return std::max(level, 0.0);
    if (r.late()) level = s.force;
    if (r.stribeck != 0 && !r.late()) {
        const double u = (r.lag > 0 ? s.speed : speed) / r.stribeck_velocity;
        if (u < 40)
            level += r.stribeck * std::exp(-(r.exponent == 2 ? u * u : r.exponent == 1 ? u : std::pow(u, r.exponent)));
    }
    level += direction * r.asymmetric_coulomb + r.load_coefficient * std::abs(at.transmitted);
    if (r.ripple != 0) level += r.ripple * std::sin(r.ripple_periods * at.position + r.ripple_phase);
    if (r.remembers()) level += r.A * logarithm_of(speed, r) + s.theta;
    return std::max(level, 0.0);
}

/// Slope of the friction with the speed of this instant in this direction.
inline double viscous(const Rubbing& r, double direction)
{
    return (r.late() ? 0 : r.viscous) + direction * r.asymmetric_viscous;
}

/// The state after sliding at this mean speed for h: exact for constant speed.
inline void remember(const Rubbing& r, RubState& s, double speed, double h)
{
    if (r.late()) {
        const double force = steady(r, speed);
        s.force = force + (s.force - force) * std::exp(-h / r.lag);
    } else if (r.lag > 0) {
        s.speed = speed + (s.speed - speed) * std::exp(-h / r.lag);
    }
    if (!r.remembers()) return;
    const double slip = speed * h * r.per_L;
    if (r.ageing) {
        // in terms of the age Θ: θ = B ln(Θ V*/L), Θ̇ = 1 − |v| Θ/L
        const double age = r.L / r.V_star * std::exp(s.theta / r.B);
        const double next = slip > 1e-12 ? r.L / speed + (age - r.L / speed) * std::exp(-slip) : age + h;
        s.theta = r.B * std::log(next * r.V_star / r.L);
    } else {
        const double steady = -r.B * logarithm_of(speed, r);
        s.theta = steady + (s.theta - steady) * std::exp(-slip);
    }
}

/// The state of a body that has slid at this speed for long; at rest it is that of sliding at V*, which is what the
/// law's level means.
inline RubState settled(const Rubbing& r, double speed)
{
    RubState s;
    s.speed = speed;
    s.force = steady(r, speed);
    if (r.remembers()) s.theta = speed > 0 ? -r.B * logarithm_of(speed, r) : 0;
    return s;
}

/// One step of a body that slides against a given level of friction: everything but velocity and force is divided out,
/// so that a friction that does not change does it once for many steps.
struct Glide {
    double keep, per_force, held;
    Glide(double level, double slope, double mobility)
    {
        const double yielding = 1 / (1 + 0.5 * mobility * slope);
        keep = (1 - 0.5 * mobility * slope) * yielding;
        per_force = mobility * yielding;
        held = per_force * std::max(level, 0.0);
    }
    double operator()(double v, double force) const
    {
        const double free = keep * v + per_force * force;
        return free - std::max(-held, std::min(free, held));
    }
};

/// Whether friction is one level and one slope, in both directions and at all times.
inline bool glides(const Rubbing& r)
{
    return r.plain() && r.asymmetric_viscous == 0 && r.bristle_stiffness == 0 && r.lag == 0;
}

/// Velocity after a step in which the force other than friction is `force` and inverse inertia times step is
/// `mobility`. Bristles are implicit in the new velocity, so that stiff ones stay stable; without bristles friction is
/// set-valued at rest: the body stays at rest while |force| is not above the resistance.
inline double rub(const Rubbing& r, RubState& s, double v, double force, double mobility, double h,
                  const Surroundings& at)
{
    const double direction = v != 0 ? std::copysign(1.0, v) : std::copysign(1.0, force);
    const double level = resistance(r, s, std::abs(v), direction, at);
    const double slope = viscous(r, direction);
    if (r.bristle_stiffness > 0 && level > 0) {
        // ż = v − σ0 |v| z / level; z' = (z + h v')/(1 + h σ0 |v|/level); f = σ0 z' + σ1 (z' − z)/h + slope v'
        const double decay = 1 / (1 + h * r.bristle_stiffness * std::abs(v) / level);
        const double stiff = r.bristle_stiffness + r.bristle_damping / h;
        const double fixed = stiff * decay * s.bristle - r.bristle_damping / h * s.bristle;
        const double next = (v + mobility * (force - fixed)) / (1 + mobility * (stiff * decay * h + slope));
        s.bristle = (s.bristle + h * next) * decay;
        remember(r, s, 0.5 * std::abs(v + next), h);
        return next;
    }
    const double next = Glide(level, slope, mobility)(v, force);
    remember(r, s, 0.5 * std::abs(v + next), h);
    return next;
}

}  // namespace stickslip::gap
