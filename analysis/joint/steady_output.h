// What a controller is made to ask for in steady sliding: how much of it its integral holds, and the position error
// that gives what is left.
#pragma once
#include "analysis/joint/gains.h"

namespace stickslip {

struct SteadyOutput {
    double error = 0;  ///< of the position, the dead zone included; NaN within the jump of a push, where none gives it
    double held = 0;   ///< by the integral
    bool at_limit = false;  ///< the integral would have to hold more
};

/// Of the output `command` while the reference moves at `rate` and the controller reads `velocity`, without gravity fed
/// forward. An integral of the position error leaves none, that of a cascade leaves none of its velocity error
/// K_pos e + ė, so that what ė keeps stands in e. Within a dead zone any error is steady: 0 is given.
SteadyOutput steady_output(const Control& control, double command, double rate, double velocity);

/// share · ṙ − v, or −v without a reference velocity.
inline double velocity_error(const Control& control, double rate, double velocity)
{
    return (control.reference_velocity ? control.feed_forward.velocity * rate : 0) - velocity;
}

/// What a push by the velocity adds per velocity about v: so much less damping, behind the same estimate as k_v.
inline double push_slope(const FeedForward& f, double v)
{
    return f.by_velocity() ? f.coulomb * f.direction(v).slope : 0;
}

}  // namespace stickslip
