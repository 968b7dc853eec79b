#include "sweep/files/toml/robot_table.h"

#include "sweep/files/robots/robot_file.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/toml/hand_keys.h"
#include "sweep/files/toml/struct_reader.h"
#include "sweep/study/import/import.h"
#include "sweep/study/import/posed_robot.h"

#include <xxhash.h>

#include <algorithm>

namespace stickslip {

std::vector<double> read_pose(const Robot& robot, const std::filesystem::path& file)
{
    std::vector<double> pose;
    for (const auto& joint : robot.joints) pose.push_back(joint.reference);
    if (file.empty()) return pose;
    const auto table = files::parse_toml(files::read_text(file), file.string());
    files::Complaints complaints(file.string());
    const auto names = movable_joints(robot);
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

namespace files {
namespace {

/// Where a spec has its robot, and what names it: a file, or the description itself.
struct Described {
    std::string name, text;
    Robot robot;
};

Described described(const std::string& file, const std::string& description, const std::filesystem::path& folder)
{
    if (file.empty()) return {"robot", description, read_robot_text(description, "robot")};
    const auto path = folder / file;
    return {path.string(), robot_text(path), read_robot(path)};
}

std::string identity_of(const Described& of, const std::string& joint, double armature)
{
    const std::string all = joint + "\n" + number_text(armature) + "\n" + of.text;
    const auto hash = XXH3_128bits(all.data(), all.size());
    return "robot " + std::to_string(hash.high64) + " " + std::to_string(hash.low64);
}

/// Whether the joint file and the robot mean the same kind of joint, and it moves while all others stand still.
bool suits(const RobotJoint& in_robot, const ImportAnswer& imported, const Joint& joint, const Place& place,
           Complaints& complaints)
{
    if (imported.loop) {
        complaints.add(place, "robot.joint",
                       "is \"" + in_robot.name + "\", through which " + imported.loop->what + " closes a loop (" +
                           imported.loop->place + "), expected a joint that moves while all others stand still");
        return false;
    }
    const bool turns = in_robot.kind == RobotJointKind::hinge;
    if (turns == (joint.mechanism.motion == Motion::revolute)) return true;
    complaints.add(place, "robot.joint",
                   "is \"" + in_robot.name + "\", which " + (turns ? "turns" : "slides") + " (" + in_robot.place +
                       "), expected one that " + (turns ? "slides" : "turns") +
                       " as the joint file has it: joint.motion");
    return false;
}

}  // namespace

void read_robot_table(const toml::table& spec, const std::filesystem::path& folder, Joint& joint,
                      Complaints& complaints)
{
    const auto* table = table_at(spec, "robot", "", complaints);
    if (!table) return;
    const auto before = complaints.count();
    complain_unknown_keys(*table, names_of(spec_keys, "robot"), "robot", complaints);
    std::string file, name, description;
    read_text_at(*table, "file", "robot", file, complaints);
    read_text_at(*table, "description", "robot", description, complaints);
    read_text_at(*table, "joint", "robot", name, complaints);
    double armature = 0;
    const Field field{"armature", Quantity::inertia, not_negative, Need::optional, ""};
    if (const auto* node = table->get("armature"))
        if (const auto problem = read_number(*node, field, units_of(joint), armature); !problem.empty())
            complaints.add(node->source(), "robot.armature", problem);
    if (file.empty() == description.empty())
        complaints.add(Place(table->source()), "robot.file", "is missing, expected a robot description, URDF or MJCF");
    if (name.empty())
        complaints.add(Place(table->source()), "robot.joint", "is missing, expected which of its joints this one is");
    if (complaints.count() > before) return;
    try {
        auto of = described(file, description, folder);
        const int index = joint_named(of.robot, name, of.name);
        const auto imported = import_joint(of.robot, index, read_pose(of.robot, {}));
        const auto& in_robot = of.robot.joints[static_cast<std::size_t>(index)];
        if (!suits(in_robot, imported, joint, Place(table->get("joint")->source()), complaints)) return;
        place_in_robot(joint, of.robot, index, armature, identity_of(of, name, armature));
    } catch (const BadInput& bad) {
        complaints.add_foreign(bad.messages());
    }
}

}  // namespace files
}  // namespace stickslip
