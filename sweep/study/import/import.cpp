#include "sweep/study/import/import.h"

#include "analysis/joint/parameters.h"

namespace stickslip {

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
    for (const int j : beyond_limits(robot, pose))
        answer.beyond.push_back({robot.joints[static_cast<std::size_t>(j)], pose[static_cast<std::size_t>(j)]});
    const auto& d = answer.dynamics;

    Joint& j = answer.joint;
    const bool hinge = described.kind == RobotJointKind::hinge;
    j.mechanism.motion = hinge ? Motion::revolute : Motion::prismatic;
    j.mechanism.inertia = d.inertia + described.armature;
    j.load.gravity_amplitude = d.gravity_amplitude;
    j.load.gravity_phase = d.gravity_phase;
    if (!hinge) j.load.constant = d.gravity_effort;
    CoulombViscous law;
    law.coulomb = described.friction;
    law.viscous = described.damping;
    j.friction.law = law;
    j.control.k_p = described.k_p;
    if (is_set(described.k_v)) j.control.k_v = described.k_v;
    if (described.effort > 0) j.control.effort_limit = described.effort;
    if (described.driven && !is_set(described.k_p) && described.gear != 0)
        j.actuator.effort_gain = described.gear;  // effort of the joint per unit of the motor's
    for (const auto& p : parameters(j))
        if (p.need == Need::required && !is_set(*p.value)) answer.missing.push_back(p.path);
    return answer;
}

}  // namespace stickslip
