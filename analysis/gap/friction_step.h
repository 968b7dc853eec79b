// Friction inside one time step: how hard a body resists, and what is left of its velocity.
#pragma once
#include "analysis/gap/plant.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

/// What one body's friction remembers between steps.
struct RubState {
    double bristle = 0;  ///< deflection z
    double theta = 0;    ///< memory state
    double speed = 0;    ///< lagged speed, for a law that follows velocity late
};

/// Where and when a step happens, as far as friction asks.
struct Surroundings {
    double position = 0, time = 0, transmitted = 0;
};

/// Added to the speed inside the logarithms of the memory, as a part of V*: what keeps them finite at rest.
inline constexpr double memory_floor = 1e-3;

/// The resisting force apart from viscous friction and asymmetric_viscous, never negative, for motion in `direction`.
inline double resistance(const Rubbing& r, const RubState& s, double speed, double direction, const Surroundings& at)
{
    double level = r.coulomb;
    if (r.plain()) return level;
    if (r.stribeck != 0) {
        const double u = (r.lag > 0 ? s.speed : speed) / r.stribeck_velocity;
        if (u < 40)
            level += r.stribeck * std::exp(-(r.exponent == 2 ? u * u : r.exponent == 1 ? u : std::pow(u, r.exponent)));
    }
    level += direction * r.asymmetric_coulomb + r.load_coefficient * std::abs(at.transmitted);
    if (r.ripple != 0) level += r.ripple * std::sin(r.ripple_periods * at.position + r.ripple_phase);
    if (r.drift != 0) level += r.drift * -std::expm1(-at.time / r.drift_time);
    if (r.remembers()) level += r.A * std::log(speed / r.V_star + memory_floor) + s.theta;
    return std::max(level, 0.0);
}

/// Slope of the friction with speed in this direction.
inline double viscous(const Rubbing& r, double direction)
{
    return r.viscous + direction * r.asymmetric_viscous;
}

/// The state after sliding at this mean speed for h: exact for constant speed.
inline void remember(const Rubbing& r, RubState& s, double speed, double h)
{
    if (r.lag > 0) s.speed = speed + (s.speed - speed) * std::exp(-h / r.lag);
    if (!r.remembers()) return;
    const double slip = speed * h / r.L;
    if (r.ageing) {
        // in terms of the age Θ: θ = B ln(Θ V*/L), Θ̇ = 1 − |v| Θ/L
        const double age = r.L / r.V_star * std::exp(s.theta / r.B);
        const double next = slip > 1e-12 ? r.L / speed + (age - r.L / speed) * std::exp(-slip) : age + h;
        s.theta = r.B * std::log(next * r.V_star / r.L);
    } else {
        const double steady = -r.B * std::log(speed / r.V_star + memory_floor);
        s.theta = steady + (s.theta - steady) * std::exp(-slip);
    }
}

/// The state of a body that has slid at this speed for long; at rest it is that of sliding at V*, which is what the
/// law's level means.
inline RubState settled(const Rubbing& r, double speed)
{
    RubState s;
    s.speed = speed;
    if (r.remembers()) s.theta = speed > 0 ? -r.B * std::log(speed / r.V_star + memory_floor) : 0;
    return s;
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
    const double yielding = 1 / (1 + 0.5 * mobility * slope);
    const double free = (v + mobility * (force - 0.5 * slope * v)) * yielding;
    const double held = mobility * level * yielding;
    const double next = std::copysign(std::max(std::abs(free) - held, 0.0), free);
    remember(r, s, 0.5 * std::abs(v + next), h);
    return next;
}

}  // namespace stickslip::gap
