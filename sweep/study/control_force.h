// The force by which the loop drives a joint along a simulated motion.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/trajectory.h"

#include <vector>

namespace stickslip {

/// One value for each sample of the motion: u = f_ss(V_0) − k_p x − k_v (V − V_0), x and V of the one body, Dupont (3).
/// Empty where this is not the force of the loop: several bodies, other kinds of control, a loop with samples, delays,
/// integral action or filters, a set point.
std::vector<double> control_force(const Joint& joint, const Trajectory& motion);

}  // namespace stickslip
