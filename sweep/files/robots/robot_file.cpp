#include "sweep/files/robots/robot_file.h"

#include "sweep/files/robots/mjcf_input.h"
#include "sweep/files/robots/robot_xml.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/names.h"

namespace stickslip {
namespace {

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

bool is_mjcf(const files::XmlFile& xml)
{
    return xml.root().name() != std::string("robot");
}

Robot robot_of(files::XmlFile xml, const std::string& name, const std::filesystem::path& folder)
{
    const std::string root = xml.root().name();
    if (root != "robot" && root != "mujoco" && root != "mujocoinclude")
        throw BadInput(name + ": its outermost element is <" + root + ">, expected <robot> (URDF) or <mujoco> (MJCF)");
    Robot robot = is_mjcf(xml) ? files::read_mjcf(std::move(xml), folder) : files::read_urdf(xml);
    if (movable_joints(robot).empty()) throw BadInput(name + ": has no joint that moves");
    require_inertia(robot);
    return robot;
}

}  // namespace

Robot read_robot(const std::filesystem::path& file)
{
    return robot_of(files::XmlFile(file), file.string(), file.parent_path());
}

Robot read_robot_text(const std::string& text, const std::string& name)
{
    return robot_of(files::XmlFile(name, text), name, {});
}

std::string robot_text(const std::filesystem::path& file)
{
    files::XmlFile xml(file);
    if (!is_mjcf(xml)) return xml.text();
    return files::MjcfInput(std::move(xml), file.parent_path()).file.text();
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
    const auto names = movable_joints(robot);
    throw BadInput(source + ": there is no joint \"" + name + "\" that moves; joints are " + files::listed(names) +
                   files::did_you_mean(name, names));
}

}  // namespace stickslip
