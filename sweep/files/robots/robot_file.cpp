#include "sweep/files/robots/robot_file.h"

#include "sweep/files/robots/xml_input.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/toml/struct_reader.h"

#include <algorithm>

namespace stickslip {
namespace {

std::vector<std::string> movable(const Robot& robot)
{
    std::vector<std::string> names;
    for (const auto& joint : robot.joints)
        if (joint.kind != RobotJointKind::fixed) names.push_back(joint.name);
    return names;
}

/// A body that a joint moves and that has no mass of its own, nor anything fixed to it that has, has no equation of
/// motion.
void require_inertia(const Robot& robot)
{
    for (const auto& joint : robot.joints) {
        if (joint.kind == RobotJointKind::fixed || joint.armature > 0) continue;
        double mass = 0;
        for (std::size_t b = 0; b < robot.bodies.size(); ++b)
            if (moves(robot, static_cast<int>(&joint - robot.joints.data()), static_cast<int>(b)))
                mass += robot.bodies[b].mass;
        const auto& body = robot.bodies[static_cast<std::size_t>(joint.body)];
        if (mass <= 0)
            throw BadInput(
                body.place + ": " + body.name + " is moved by joint \"" + joint.name +
                "\" and has no inertia, nor has anything on it; expected an <inertial> with mass and inertia");
    }
}

}  // namespace

Robot read_robot(const std::filesystem::path& file)
{
    const std::string root = files::XmlFile(file).root().name();
    if (root != "robot" && root != "mujoco" && root != "mujocoinclude")
        throw BadInput(file.string() + ": its outermost element is <" + root +
                       ">, expected <robot> (URDF) or <mujoco> (MJCF)");
    Robot robot = root == "robot" ? files::read_urdf(file) : files::read_mjcf(file);
    if (movable(robot).empty()) throw BadInput(file.string() + ": has no joint that moves");
    require_inertia(robot);
    return robot;
}

int joint_named(const Robot& robot, const std::string& name, const std::string& source)
{
    int found = -1;
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
        const auto& joint = robot.joints[i];
        if (joint.name != name || joint.kind == RobotJointKind::fixed) continue;
        if (found >= 0) throw BadInput(joint.place + ": there are two joints called \"" + name + "\"");
        found = static_cast<int>(i);
    }
    if (found >= 0) return found;
    const auto names = movable(robot);
    throw BadInput(source + ": there is no joint \"" + name + "\" that moves; joints are " + files::listed(names) +
                   files::did_you_mean(name, names));
}

std::vector<double> read_pose(const Robot& robot, const std::filesystem::path& file)
{
    std::vector<double> pose;
    for (const auto& joint : robot.joints) pose.push_back(joint.reference);
    if (file.empty()) return pose;
    const auto table = files::parse_toml(files::read_text(file), file.string());
    files::Complaints complaints(file.string());
    const auto names = movable(robot);
    for (const auto& [name, node] : files::in_file_order(table)) {
        const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                        [&wanted = name](const RobotJoint& j) { return j.name == wanted; });
        if (found == robot.joints.end() || found->kind == RobotJointKind::fixed) {
            complaints.add(
                node->source(), name,
                "is not a joint of the robot; joints are " + files::listed(names) + files::did_you_mean(name, names));
            continue;
        }
        const Motion motion = found->kind == RobotJointKind::hinge ? Motion::revolute : Motion::prismatic;
        const Field field{"position", Quantity::position};
        double& value = pose[static_cast<std::size_t>(found - robot.joints.begin())];
        const auto problem = files::read_number(*node, field, Units(motion), value);
        if (!problem.empty()) complaints.add(node->source(), name, problem);
    }
    complaints.throw_if_any();
    return pose;
}

}  // namespace stickslip
