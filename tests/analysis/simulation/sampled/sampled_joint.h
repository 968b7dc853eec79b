// A sampled joint under dry and viscous friction and the motion that it is told to make, for the tests of records.
#pragma once
#include "analysis/simulation/sampled/loop_record.h"

#include <cmath>

namespace stickslip {

inline Joint sampled_joint()
{
    Joint joint;
    joint.mechanism.inertia = 2;
    joint.control.k_p = 4000, joint.control.k_v = 120, joint.control.period = 1e-3;
    joint.control.delay = 2e-3;
    joint.control.velocity_estimate.form = EstimateForm::backward_difference;
    joint.control.velocity_estimate.tau = 3e-3;
    joint.friction.law = CoulombViscous{5, 10};
    return joint;
}

/// To and fro over 0.1 m at 6 rad/s, from rest.
inline ReferenceMotion swing(double seconds, double tick, double start = 0)
{
    ReferenceMotion r;
    const double w = 6;
    for (int k = 0; k * tick <= seconds; ++k) {
        r.time.push_back(start + k * tick);
        r.position.push_back(0.05 * (1 - std::cos(w * k * tick)));
        r.velocity.push_back(0.05 * w * std::sin(w * k * tick));
    }
    return r;
}

}  // namespace stickslip
