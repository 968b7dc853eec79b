// A robot as its description has it: bodies in a tree, joints between them. Plain data; files/robots reads it.
#pragma once
#include <Eigen/Geometry>

#include <string>
#include <vector>

#include "analysis/base/field.h"

namespace stickslip {

enum class RobotJointKind { hinge, slide, fixed };

/// One degree of freedom of its body. `anchor` and `axis` stand in the frame of the body, before its joints move it.
struct RobotJoint {
    std::string name;
    RobotJointKind kind = RobotJointKind::hinge;
    int body = 0;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(), anchor = Eigen::Vector3d::Zero();
    double reference = 0;  ///< coordinate at which the body stands as drawn
    double damping = 0, friction = 0, armature = 0;
    double low = -infinity, high = infinity, effort = infinity, velocity = infinity;
    double gear = 1, k_p = not_set, k_v = not_set;  ///< of the actuator that drives it, where there is one
    bool driven = false;
    std::string place;  ///< "robot.urdf:12"
};

struct RobotBody {
    std::string name;
    int parent = -1;                                          ///< -1: the world
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();  ///< in the frame of the parent
    std::vector<int> joints;                                  ///< that move it, in order
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass, axes of the body
    std::string place;
};

/// Two bodies that something else than the tree holds together, or two joints whose coordinates do: an equality of
/// MJCF, a <mimic> of URDF. -1 is the world, or no joint.
struct RobotClosure {
    int a = -1, b = -1;           ///< bodies
    int first = -1, second = -1;  ///< joints
    std::string place, what;
};

/// Bodies come after their parents.
struct Robot {
    std::vector<RobotBody> bodies;
    std::vector<RobotJoint> joints;
    std::vector<RobotClosure> closures;
    Eigen::Vector3d gravity{0, 0, -9.81};
};

/// What the rest of a robot is to one of its axes while all other joints stand still.
struct AxisDynamics {
    double inertia = 0;            ///< of everything that the joint moves, without armature: kg·m² or kg
    double mass = 0;               ///< of everything that it moves
    double gravity_amplitude = 0;  ///< hinge: effort −amplitude · sin(q + phase)
    double gravity_phase = 0;
    double gravity_effort = 0;     ///< at this pose
    double gravity_stiffness = 0;  ///< −d effort / dq at this pose
    int bodies = 0;
};

/// Principal moments that no rigid body has: the greatest is above the sum of the others.
struct ImpossibleInertia {
    std::string body, place;
    Eigen::Vector3d moments = Eigen::Vector3d::Zero();  ///< kg·m², ascending
};

/// Of the bodies that a joint moves. Written with few digits, a flat body may be above the sum by their rounding.
std::vector<ImpossibleInertia> impossible_inertias(const Robot& robot, int joint);

/// A number that no arm has in metres and radians, as descriptions in millimetres and degrees do.
struct SuspectedUnit {
    enum class Kind { length, angle };
    Kind kind = Kind::length;
    std::string of, place;
    double value = 0;  ///< m: the farthest of a body; rad: between the limits of a joint
};

/// Of the bodies that a joint moves, and of its limits.
std::vector<SuspectedUnit> suspected_units(const Robot& robot, int joint);

/// `pose` has one coordinate a joint.
AxisDynamics axis_dynamics(const Robot& robot, int joint, const std::vector<double>& pose);

/// Joints that stand where their limits do not let them.
std::vector<int> beyond_limits(const Robot& robot, const std::vector<double>& pose);

/// Whether a joint moves the body.
bool moves(const Robot& robot, int joint, int body);

/// Whether a joint cannot turn without what the closure adds to the tree.
bool passes_through(const Robot& robot, const RobotClosure& closure, int joint);

}  // namespace stickslip
