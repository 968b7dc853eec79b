// What the rest of a moving robot does to each of its joints: gravity, centrifugal and Coriolis forces, the pull of the
// other joints' accelerations, and the inertia at the pose.
#pragma once
#include "sweep/study/import/robot.h"

#include <cstdint>
#include <string>
#include <vector>

namespace stickslip {

/// Position, velocity and acceleration of one joint at each row.
struct JointMotion {
    std::vector<double> position, velocity, acceleration;
};

struct JointLoad {
    std::vector<double> load;     ///< effort of the rest of the robot, positive along the motion: load_effort
    std::vector<double> inertia;  ///< about the axis, without armature
};

/// Efforts at the joints that hold the frictionless robot on a motion, one coordinate a joint, by the Newton-Euler
/// recursion outwards (Luh, Walker, Paul 1980, J. Dyn. Sys. Meas. Control 102, 69-76) and the projection of the bodies'
/// inertial forces on each axis. Armature and springs are left to the joint.
std::vector<double> inverse_dynamics(const Robot& robot, const std::vector<double>& q, const std::vector<double>& dq,
                                     const std::vector<double>& ddq);

/// A cubic through the rows within half a `window` of each row, at both ends through the first or last window, by least
/// squares (Savitzky, Golay 1964, Anal. Chem. 36, 1627-1639; rows need not be evenly spaced). Throws
/// std::invalid_argument where fewer than five rows lie in a window.
JointMotion smoothed(const std::vector<double>& time, const std::vector<double>& position, double window);

/// The motion as if it were measured again: what differs from `motion` is an example of what that is wrong by
/// (parametric bootstrap: Efron, Tibshirani 1993, An Introduction to the Bootstrap, 6.5). The smoothed motion is taken
/// for true, with fresh noise of the size that the readings have; and its accelerations are smeared once more, as those
/// of corners were: what that changes of a position is the same again, half the kernel's second moment times the jump.
JointMotion measured_again(const std::vector<double>& time, const std::vector<double>& position,
                           const JointMotion& motion, double window, std::uint64_t seed);

/// Loads of those joints that `moved` has, by index of the joint; the others stand still at the `pose`.
std::vector<JointLoad> arm_loads(const Robot& robot, const std::vector<int>& moved,
                                 const std::vector<JointMotion>& joint_motions, const std::vector<double>& pose);

}  // namespace stickslip
