// The joint of a record, flattened for speed: what joint.h describes, as bare numbers that the time step can use.
#pragma once
#include "analysis/joint/joint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::gap {

/// Friction on one body. The law is (coulomb + stribeck exp(−(|v|/stribeck_velocity)^exponent) + viscous |v|) sgn v;
/// the terms are those of friction.h. Zero means absent. Real: a number, or a pack of them.
template <class Real>
struct FlatFrictionOf {
    Real coulomb = 0, viscous = 0;
    Real stribeck = 0, stribeck_velocity = 1, exponent = 2;
    Real asymmetric_coulomb = 0, asymmetric_viscous = 0;
    Real load_coefficient = 0;
    Real gear_forward = 0, gear_backward = 0, gear_beyond = 1;
    Real ripple = 0, ripple_periods = 1, ripple_phase = 0, second_ripple = 0, second_phase = 0;
    Real drift = 0, drift_time = 1;
    Real bristle_stiffness = 0, bristle_damping = 0;
    Real A = 0, B = 0, L = 1, V_star = 1, lag = 0;
    Real per_L = 1, per_V_star = 1;
    bool ageing = false;
    bool lag_viscous = false;  ///< what lags is the force of the whole curve, viscous friction included
};

struct FlatFriction : FlatFrictionOf<double> {
    bool remembers() const { return A != 0 || B != 0; }
    bool late() const { return lag > 0 && lag_viscous; }
    bool geared() const { return gear_forward != 0 || gear_backward != 0; }
    /// Apart from its drift, which a tick holds.
    bool plain() const
    {
        return stribeck == 0 && asymmetric_coulomb == 0 && load_coefficient == 0 && !geared() && ripple == 0 &&
               second_ripple == 0 && !remembers() && !late();
    }
};

/// A force on the link as free functions of its position and velocity, or an inertia that changes with time: what no
/// effect of the catalogue has the shape of. Of position and of time: quadratic splines over equal intervals.
struct FreeForce {
    static constexpr std::size_t intervals = 8, coefficients = intervals + 2;
    bool present = false;
    double from = 0, width = 1;
    double play = 0;  ///< half of it: q is where a follower is, which the position drags along (play operator)
    std::array<double, coefficients> of_position{};
    double speed = 1, linear = 0, quadratic = 0, cubic = 0;  ///< forces at that speed, against the motion
    bool moves_inertia = false;
    double time_from = 0, time_width = 1;           ///< s
    std::array<double, coefficients> of_inertia{};  ///< per inertia of the joint, added to it

    double at(double q, double v) const
    {
        const double w = v / speed;
        return spline(of_position, (q - from) / width) - w * (linear + std::abs(w) * (quadratic + std::abs(w) * cubic));
    }
    /// Inertia at a time per inertia of the joint.
    double inertia_factor(double t) const
    {
        constexpr double least = 0.05;  // numerical: an inertia is positive wherever a search goes
        return std::max(least, 1 + spline(of_inertia, (t - time_from) / time_width));
    }

  private:
    static double spline(const std::array<double, coefficients>& c, double intervals_from_start)
    {
        const double x = std::clamp(intervals_from_start, 0.0, static_cast<double>(intervals) - 1e-9);
        const auto i = static_cast<std::size_t>(x);
        const double u = x - static_cast<double>(i);
        return 0.5 * (1 - u) * (1 - u) * c[i] + (0.5 + u * (1 - u)) * c[i + 1] + 0.5 * u * u * c[i + 2];
    }
};

/// Of two masses: how fast motor, seen through the reduction, and link accelerate apart per force of the spring between
/// them, 1/J_l + 1/(N² J_m).
template <class Number>
Number apart_per_force(const Number& motor_inertia, const Number& link_inertia, const Number& ratio)
{
    return Number(1.0) / link_inertia + Number(1.0) / (ratio * ratio * motor_inertia);
}

struct Plant {
    bool two_mass = false;
    double motor_inertia = 1, link_inertia = 1;  ///< single mass: motor_inertia is all
    double stiffness = 0, cubic_stiffness = 0, damping = 0, ratio = 1, backlash = 0;
    FlatFriction motor, link;  ///< single mass: motor
    Load load;
    FreeForce free;
    Actuator actuator;
    double dead_time = 0;  ///< of the loop: the motion that is read now is that of a command so long ago
    Control control;
    Sensor sensor;
    bool feedback_link = false;
    double step_factor = 1;  ///< by which time steps are longer than accuracy asks for

    bool dc_motor() const { return actuator.kind == ActuatorKind::dc_motor; }
    /// Motion of the motor, and of the link, per motion that the encoder sees.
    double motor_per_seen() const { return two_mass && feedback_link ? ratio : 1; }
    double link_per_seen() const { return two_mass && !feedback_link ? 1 / ratio : 1; }
    /// Effort at the motor per acceleration that the encoder sees, both bodies moving as one: through a reduction N the
    /// motor feels M_l/N of the link's acceleration.
    double driven_inertia() const
    {
        return motor_inertia * motor_per_seen() + (two_mass ? link_inertia / ratio * link_per_seen() : 0);
    }
    /// Effort at the motor per unit of the command, at rest and within every limit.
    double effort_per_command() const
    {
        if (!dc_motor()) return actuator.effort_gain;
        const double volts = actuator.signal == DriveSignal::duty ? actuator.supply_voltage : 1;
        return actuator.effort_gain * actuator.k_t / actuator.resistance * volts;
    }
};

/// The joint as a record sees it. Throws std::invalid_argument for a model or law that has no record simulation
/// (three masses, lever; laws without sticking such as a kernel).
Plant flatten(const Joint& joint);

/// The longest time step that is no part of the answer.
double longest_step(const Plant& plant);
/// Substeps of at most that length in a tick of this one.
int substeps(double tick, double longest);

}  // namespace stickslip::gap
