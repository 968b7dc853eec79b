#include "sweep/study/import/import.h"

#include "analysis/joint/parameters.h"
#include "sweep/study/import/posed_robot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stickslip {
namespace {

/// Servos close the loop: their gains are the joint's, and the effort that they may have limits its command.
void take_servo(const RobotJoint& described, double inertia, Joint& joint)
{
    const auto& servo = described.servo;
    auto& c = joint.control;
    const double by_ratio = servo.per_root_inertia * std::sqrt(inertia);
    const double own = servo.own_k_v + by_ratio;
    c.k_p = servo.k_p;
    if (is_set(servo.k_v)) c.k_v = servo.k_v + by_ratio;
    if (own != 0 && own == c.k_v) c.reference_velocity = false;
    if (own != 0 && own != c.k_v) c.feed_forward.velocity = 1 - own / c.k_v;
    const double limit = std::min(described.effort, servo.effort_limit);
    if (limit > 0) c.effort_limit = limit;
}

/// The limit of a motor's command stands before its gear, that of its effort behind the filter.
void take_motor(const RobotJoint& described, Joint& joint)
{
    const auto& motor = described.motor;
    joint.actuator.effort_gain = motor.effort_per_command;
    joint.actuator.lag = motor.lag;
    joint.control.delay = motor.delay;
    if (motor.command_limit > 0) joint.control.effort_limit = motor.command_limit;
    const double limit = std::min(described.effort, motor.effort_limit);
    if (limit > 0) joint.actuator.limit = limit;
}

/// About the axis where the robot stands as drawn: MuJoCo makes damping ratios of it.
double reference_inertia(const Robot& robot, int joint)
{
    std::vector<double> drawn;
    for (const auto& j : robot.joints) drawn.push_back(j.reference);
    return axis_dynamics(robot, joint, drawn).inertia + robot.joints[static_cast<std::size_t>(joint)].armature;
}

}  // namespace

ImportAnswer import_joint(const Robot& robot, int joint, const std::vector<double>& pose)
{
    ImportAnswer answer;
    for (const auto& closure : robot.closures)
        if (passes_through(robot, closure, joint)) answer.loop = &closure;
    const auto& described = robot.joints[static_cast<std::size_t>(joint)];
    answer.described = described;
    answer.position = pose[static_cast<std::size_t>(joint)];
    answer.dynamics = axis_dynamics(robot, joint, pose);
    answer.impossible = impossible_inertias(robot, joint);
    answer.suspected = suspected_units(robot, joint);
    std::ranges::copy_if(robot.not_taken, std::back_inserter(answer.not_taken),
                         [&](const NotTaken& of) { return acts_on(robot, of, joint); });
    for (const int j : beyond_limits(robot, pose))
        answer.beyond.push_back({robot.joints[static_cast<std::size_t>(j)], pose[static_cast<std::size_t>(j)]});

    Joint& j = answer.joint;
    j.mechanism.motion = described.kind == RobotJointKind::hinge ? Motion::revolute : Motion::prismatic;
    take_dynamics(answer.dynamics, described.armature, j);
    CoulombViscous law;
    law.coulomb = described.friction;
    law.viscous = described.damping;
    j.friction.law = law;
    if (is_set(described.motor.effort_per_command))
        take_motor(described, j);
    else
        take_servo(described, reference_inertia(robot, joint), j);
    for (const auto& p : parameters(j))
        if (p.need == Need::required && !is_set(*p.value)) answer.missing.push_back(p.path);
    return answer;
}

}  // namespace stickslip
