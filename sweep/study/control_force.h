// The force by which the loop drives a joint along a simulated motion.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/trajectory.h"

#include <vector>

namespace stickslip {

/// One value for each sample of the motion: u = u_ss − k_p x − k_v (V − V_0) within its limits, x and V of the one
/// body, u_ss = f_ss(V_0) less the load, Dupont (3). Empty where this is not the force of the loop: several bodies,
/// other kinds of control, a loop with samples, delays, integral action or filters, a dead zone or a push that follows
/// the motion, loads that depend on the place or on time, a set point.
std::vector<double> control_force(const Joint& joint, const Trajectory& motion);

}  // namespace stickslip
