// One joint of a robot at every pose of the others, as a joint of ours needs it.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/study/import/robot.h"

#include <memory>
#include <string>

namespace stickslip {

/// Inertia and gravity of the axis, and the armature behind its gear: of a single mass the inertia is that of both, of
/// several masses the link has the axis' alone.
void take_dynamics(const AxisDynamics& axis, double armature, Joint& joint);

/// Makes `joint` the one of that index in the robot: its `pose` then has every other joint that moves, each at its
/// reference, and inertia and gravity are those of the pose. `armature` comes on top of that in the description;
/// `identity` says which description it is.
void place_in_robot(Joint& joint, Robot robot, int index, double armature, const std::string& identity);

}  // namespace stickslip
