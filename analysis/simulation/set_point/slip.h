// One slip of a mass under PID position control between two stops, in closed form.
#pragma once
#include "analysis/base/field.h"
#include "analysis/results/point.h"

namespace stickslip {

/// A mass under u = k_p e + k_v ė + k_i ∫e about a set point. `damping` is all that is proportional to velocity: k_v
/// and the viscous part of friction.
struct PidMass {
    double inertia = not_set, damping = 0, k_p = not_set, k_i = not_set;

    /// Routh: without dry friction the loop settles.
    bool stable() const
    {
        return inertia > 0 && damping > 0 && k_i > 0 && damping * k_p > inertia * k_i;
    }
};

/// Friction that does not depend on the size of the velocity: F_c in motion, up to F_s at rest.
struct DryFriction {
    double coulomb = not_set, breakaway = not_set;
};

/// h, ḣ and ḧ of the impulse response of 1/(m s³ + c s² + k_p s + k_i), and H = ∫h. It is h1 of the slip (the answer to
/// a step of force), and k_i H is h2 (the answer to the ramp by which the integrator winds up).
struct SlipResponse {
    double h = 0, rate = 0, acceleration = 0, integral = 0;
};
SlipResponse slip_response(const PidMass& mass, double t);

/// The symmetric cycle of stops and slips at a set point.
struct HuntingCycle {
    bool found = false;
    double amplitude = missing;   ///< distance of the stops from the set point
    double slip_time = missing;   ///< T
    double stick_time = missing;  ///< T_s; negative: the mass would have to turn without a stop, no such cycle exists
    double multiplier = missing;  ///< by which a small change of the amplitude changes from stop to stop

    double period() const { return 2 * (slip_time + stick_time); }
};

/// From a stop at −a the integrator winds up until u = F_s; the slip δ = (F_s − F_c) h1 + a h2 ends where the velocity
/// first vanishes, and the cycle closes if it ends at +a:
///   a = (F_s − F_c) max h1/(2 − h2), attained at the slip time T, which does not depend on the friction.
/// For a stable loop h2' = k_i h1 > 0 up to T, so T is the first zero of ḣ1 (2 − h2) + k_i h1², and δ̇ has none before.
/// Then m δ̈(T) + F_c = u(T), and the next stop lasts until k_i a has carried u from there to −F_s.
/// F_s > F_c: every loop that is stable has one; F_s = F_c: a = 0, none.
HuntingCycle hunting_cycle(const PidMass& mass, const DryFriction& friction);

/// By which factor the distance from the set point changes from stop to stop where F_s = F_c: h2(T) − 1 at the first
/// zero T of h1.
double settling_multiplier(const PidMass& mass);

}  // namespace stickslip
