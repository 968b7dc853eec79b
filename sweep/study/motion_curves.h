// What a simulated motion is shown with: the force of its loop, and the friction of steady sliding.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/trajectory.h"
#include "sweep/study/samples.h"

#include <vector>

namespace stickslip {

struct MotionCurves {
    std::size_t settled_from = 0;  ///< sample with which the last third of the time begins: what the motion settled to
    /// By which the loop drives the joint, one value for each sample: u = u_ss − k_p x − k_v (V − V_0) within its
    /// limits, x and V of the one body, u_ss = f_ss(V_0) less the load, Dupont (3). Empty where this is not the force
    /// of the loop: several bodies, other kinds of control, a loop with samples, delays, integral action or filters, a
    /// dead zone or a push that follows the motion, loads that depend on the place or on time, a set point.
    std::vector<double> control_force;
    /// f_ss over the velocities that the motion has settled to, on both sides of rest where it reverses: what friction
    /// without memory would follow. Empty where it has settled to one velocity.
    Samples steady_friction;
};

/// Empty of a motion without samples.
MotionCurves motion_curves(const Joint& joint, const Trajectory& motion);

}  // namespace stickslip
