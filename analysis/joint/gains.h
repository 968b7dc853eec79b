// The gains that act: a cascade of a velocity loop inside a position loop is one sum of gains while nothing saturates.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// u = k_p e + k_v ė + k_i ∫e.
struct Gains {
    double k_p = 0, k_v = 0, k_i = 0;  ///< command per position, velocity, and position and time
};

/// K_i of a cascade: as given, or K_v/T_n.
inline double velocity_integral_gain(const Control& control)
{
    if (is_set(control.velocity_integral_gain)) return control.velocity_integral_gain;
    return is_set(control.velocity_reset_time) ? control.velocity_gain / control.velocity_reset_time : 0;
}

/// Of either structure. A cascade u = K_v w + K_i ∫w on w = K_pos e + ė is k_p = K_v K_pos + K_i, k_v = K_v,
/// k_i = K_i K_pos: exactly, while nothing saturates and the velocity estimate sums to the position.
inline Gains gains_of(const Control& control)
{
    if (control.structure == Structure::pid) return {control.k_p, control.k_v, control.k_i};
    const double K_v = control.velocity_gain, K_i = velocity_integral_gain(control);
    return {K_v * control.position_gain + K_i, K_v, K_i * control.position_gain};
}

/// The number that a user turns for the position error, in either structure: k_p or K_pos.
inline double& stated_position_gain(Control& control)
{
    return control.structure == Structure::cascade ? control.position_gain : control.k_p;
}
/// The same for the velocity error: k_v or K_v.
inline double& stated_velocity_gain(Control& control)
{
    return control.structure == Structure::cascade ? control.velocity_gain : control.k_v;
}

/// The joint with the sum of gains that its cascade is, for what reads k_p, k_v and k_i; any other joint unchanged.
inline Joint with_gains(Joint joint)
{
    const Gains gains = gains_of(joint.control);
    joint.control.structure = Structure::pid;
    joint.control.k_p = gains.k_p;
    joint.control.k_v = gains.k_v;
    joint.control.k_i = gains.k_i;
    return joint;
}

}  // namespace stickslip
