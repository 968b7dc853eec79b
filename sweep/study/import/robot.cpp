#include "sweep/study/import/robot.h"

#include "sweep/study/import/placed.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {

Placed place(const Robot& robot, const std::vector<double>& pose)
{
    Placed at;
    at.body.resize(robot.bodies.size());
    at.axis.resize(robot.joints.size());
    at.anchor.resize(robot.joints.size());
    for (std::size_t b = 0; b < robot.bodies.size(); ++b) {
        const auto& body = robot.bodies[b];
        Eigen::Isometry3d frame =
            body.parent < 0 ? body.frame : at.body[static_cast<std::size_t>(body.parent)] * body.frame;
        for (const int i : body.joints) {
            const auto index = static_cast<std::size_t>(i);
            const auto& joint = robot.joints[index];
            at.axis[index] = frame.linear() * joint.axis;
            at.anchor[index] = frame * joint.anchor;
            const double moved = pose[index] - joint.reference;
            if (joint.kind == RobotJointKind::slide) frame.pretranslate(Eigen::Vector3d(moved * at.axis[index]));
            if (joint.kind != RobotJointKind::hinge) continue;
            const auto& p = at.anchor[index];
            frame =
                Eigen::Translation3d(p) * Eigen::AngleAxisd(moved, at.axis[index]) * Eigen::Translation3d(-p) * frame;
        }
        at.body[b] = frame;
    }
    return at;
}

std::vector<std::string> movable_joints(const Robot& robot)
{
    std::vector<std::string> names;
    for (const auto& joint : robot.joints)
        if (joint.kind != RobotJointKind::fixed) names.push_back(joint.name);
    return names;
}

bool moves(const Robot& robot, int joint, int body)
{
    const int moved = robot.joints[static_cast<std::size_t>(joint)].body;
    for (; body >= 0; body = robot.bodies[static_cast<std::size_t>(body)].parent)
        if (body == moved) return true;
    return false;
}

std::vector<ImpossibleInertia> impossible_inertias(const Robot& robot, int joint)
{
    constexpr double rounding = 0.01;  // share: two digits, the fewest that descriptions write
    std::vector<ImpossibleInertia> found;
    for (std::size_t b = 0; b < robot.bodies.size(); ++b) {
        if (!moves(robot, joint, static_cast<int>(b))) continue;
        const auto& body = robot.bodies[b];
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(body.inertia, Eigen::EigenvaluesOnly);
        const Eigen::Vector3d& moments = principal.eigenvalues();
        if (moments[2] > (1 + rounding) * (moments[0] + moments[1])) found.push_back({body.name, body.place, moments});
    }
    return found;
}

std::vector<SuspectedUnit> suspected_units(const Robot& robot, int joint)
{
    constexpr double longest_link = 20;                       // m; booms of the longest arms in space have 7 m
    constexpr double most_turns = 10 * 2 * std::numbers::pi;  // rad; ±45 in degrees would be 14 turns
    std::vector<SuspectedUnit> found;
    for (std::size_t b = 0; b < robot.bodies.size(); ++b) {
        if (!moves(robot, joint, static_cast<int>(b))) continue;
        const auto& body = robot.bodies[b];
        const double gyration = body.mass > 0 ? std::sqrt(body.inertia.trace() / 2 / body.mass) : 0;
        const double farthest = std::max({body.frame.translation().norm(), body.centre.norm(), gyration});
        if (farthest > longest_link) found.push_back({SuspectedUnit::Kind::length, body.name, body.place, farthest});
    }
    const auto& of = robot.joints[static_cast<std::size_t>(joint)];
    const double turned = of.high - of.low;
    if (of.kind == RobotJointKind::hinge && turned > most_turns && std::isfinite(turned))
        found.push_back({SuspectedUnit::Kind::angle, "joint \"" + of.name + "\"", of.place, turned});
    return found;
}

std::vector<int> beyond_limits(const Robot& robot, const std::vector<double>& pose)
{
    constexpr double written = 1e-4;  // rad or m: limits and poses are written with few digits
    std::vector<int> beyond;
    for (std::size_t i = 0; i < pose.size(); ++i) {
        const auto& joint = robot.joints[i];
        if (joint.kind == RobotJointKind::fixed) continue;
        if (pose[i] < joint.low - written || pose[i] > joint.high + written) beyond.push_back(static_cast<int>(i));
    }
    return beyond;
}

bool acts_on(const Robot& robot, const NotTaken& element, int joint)
{
    const auto moved = [&](int body) { return moves(robot, joint, body); };
    return element.every_joint || std::ranges::find(element.joints, joint) != element.joints.end() ||
           std::ranges::any_of(element.bodies, moved);
}

bool passes_through(const Robot& robot, const RobotClosure& closure, int joint)
{
    // coordinates that are tied stand still together wherever their bodies are
    if (closure.first >= 0 || closure.second >= 0) return joint == closure.first || joint == closure.second;
    return moves(robot, joint, closure.a) != moves(robot, joint, closure.b);
}

AxisDynamics axis_dynamics(const Robot& robot, int joint, const std::vector<double>& pose)
{
    const Placed at = place(robot, pose);
    const auto index = static_cast<std::size_t>(joint);
    const Eigen::Vector3d axis = at.axis[index], anchor = at.anchor[index];
    AxisDynamics d;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // Σ m (c − p), of the weight that is not held
    double hanging = 0;
    const bool hinge = robot.joints[index].kind == RobotJointKind::hinge;
    for (std::size_t b = 0; b < robot.bodies.size(); ++b) {
        if (!moves(robot, joint, static_cast<int>(b))) continue;
        const auto& body = robot.bodies[b];
        const Eigen::Vector3d arm = at.body[b] * body.centre - anchor;
        const Eigen::Vector3d own = at.body[b].linear().transpose() * axis;
        d.inertia += hinge ? body.mass * axis.cross(arm).squaredNorm() + own.dot(body.inertia * own) : body.mass;
        d.mass += body.mass;
        hanging += (1 - body.held_weight) * body.mass;
        moment += (1 - body.held_weight) * body.mass * arm;
        ++d.bodies;
    }
    if (!hinge) {
        d.gravity_effort = hanging * axis.dot(robot.gravity) + 0.0;  // no −0
        return d;
    }
    // the effort of gravity turns with the moment: T0 cos(q − q0) + T1 sin(q − q0) = −A sin(q + phase)
    const double T0 = axis.dot(moment.cross(robot.gravity));
    const double T1 = axis.dot(axis.cross(moment).cross(robot.gravity));
    d.gravity_effort = T0 + 0.0;
    d.gravity_stiffness = -T1 + 0.0;
    d.gravity_amplitude = std::hypot(T0, T1);
    if (d.gravity_amplitude > 1e-12 * d.mass * robot.gravity.norm())
        d.gravity_phase = std::remainder(std::atan2(-T0, -T1) - pose[index], 2 * std::acos(-1.0)) + 0.0;  // no −0
    else  // the axis is upright or nothing hangs on it, but for rounding
        d.gravity_amplitude = d.gravity_effort = d.gravity_stiffness = 0;
    return d;
}

}  // namespace stickslip
