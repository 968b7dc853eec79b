// A robot as its description has it: bodies in a tree, joints between them. Plain data; files/robots reads it.
#pragma once
#include <Eigen/Geometry>

#include <string>
#include <vector>

#include "analysis/base/field.h"

namespace stickslip {

enum class RobotJointKind { hinge, slide, fixed };

/// Servos that hold a joint, added up, at the joint's side of their gears.
struct RobotServo {
    double k_p = not_set, k_v = not_set;
    double own_k_v = 0;           ///< the part of k_v that acts on velocity alone, without a target
    double per_root_inertia = 0;  ///< of damping ratios: k_v has this times the root of the inertia in addition
    double effort_limit = infinity;
};

/// A motor that turns a command into effort, at the joint's side of its gear.
struct RobotMotor {
    double effort_per_command = not_set;
    double command_limit = infinity, effort_limit = infinity;
    double lag = 0, delay = 0;
};

/// One degree of freedom of its body. `anchor` and `axis` stand in the frame of the body, before its joints move it.
struct RobotJoint {
    std::string name;
    RobotJointKind kind = RobotJointKind::hinge;
    int body = 0;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(), anchor = Eigen::Vector3d::Zero();
    double reference = 0;  ///< coordinate at which the body stands as drawn
    double damping = 0, friction = 0, armature = 0;
    double low = -infinity, high = infinity, effort = infinity, velocity = infinity;
    double gear = 1;  ///< of the actuator that drives it, where there is one
    RobotServo servo;
    RobotMotor motor;
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
    double held_weight = 0;                             ///< share of its weight that the description takes off it
    std::string place;
};

/// Two bodies that something else than the tree holds together, or two joints whose coordinates do: an equality of
/// MJCF, a <mimic> of URDF. -1 is the world, or no joint.
struct RobotClosure {
    int a = -1, b = -1;           ///< bodies
    int first = -1, second = -1;  ///< joints
    std::string place, what;
};

enum class NotTakenReason { spring, target, coupling, actuator, limit, lopsided, nonlinear, medium, safety };
inline constexpr Choice<NotTakenReason> not_taken_reasons[] = {
    {"spring", NotTakenReason::spring},       {"target", NotTakenReason::target},
    {"coupling", NotTakenReason::coupling},   {"actuator", NotTakenReason::actuator},
    {"limit", NotTakenReason::limit},         {"asymmetric-limit", NotTakenReason::lopsided},
    {"nonlinear", NotTakenReason::nonlinear}, {"medium", NotTakenReason::medium},
    {"safety", NotTakenReason::safety}};

/// An element that acts on joints and that a joint of ours cannot express.
struct NotTaken {
    NotTakenReason reason = NotTakenReason::actuator;
    std::string place, element, name;
    std::string attributes;   ///< as they are written: stiffness="30" springref="0.5"
    std::vector<int> joints;  ///< on which it acts
    std::vector<int> bodies;  ///< it acts on every joint that moves one of them
    bool every_joint = false;
};

/// Bodies come after their parents.
struct Robot {
    std::vector<RobotBody> bodies;
    std::vector<RobotJoint> joints;
    std::vector<RobotClosure> closures;
    std::vector<NotTaken> not_taken;
    Eigen::Vector3d gravity{0, 0, -9.81};
};

/// Names of the joints that are not fixed, in order.
std::vector<std::string> movable_joints(const Robot& robot);

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

/// Whether the element acts on the joint.
bool acts_on(const Robot& robot, const NotTaken& element, int joint);

/// Whether a joint cannot turn without what the closure adds to the tree.
bool passes_through(const Robot& robot, const RobotClosure& closure, int joint);

}  // namespace stickslip
