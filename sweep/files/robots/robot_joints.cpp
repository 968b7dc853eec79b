#include "sweep/files/robots/robot_joints.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/toml_input.h"

#include <algorithm>
#include <cctype>

namespace stickslip {
namespace {

const std::vector<std::string> top_keys{"title", "joints", "record"}, entry_keys{"file", "name"};

/// Names become folders, so nothing passes that leaves the folder of the answer or hides in it.
bool can_be_folder(const std::string& name)
{
    constexpr std::string_view signs = "_-.+";
    return !name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), [&](unsigned char c) {
        return std::isalnum(c) || signs.find(static_cast<char>(c)) != signs.npos;
    });
}

/// A name twice in the log would diagnose one joint's records with two files.
void complain_shared_names(const RobotJoints& robot, files::Complaints& complaints)
{
    for (std::size_t i = 0; i < robot.joints.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (robot.joints[i].in_log == robot.joints[j].in_log)
                complaints.add({}, "joints." + robot.joints[i].name,
                               "is called \"" + robot.joints[i].in_log + "\" in the log, as " + robot.joints[j].name +
                                   " is; expected a name of its own for each joint");
}

RobotJointFile read_entry(const std::string& name, const toml::node& node, const std::filesystem::path& folder,
                          files::Complaints& complaints)
{
    RobotJointFile joint{name, name, {}};
    const std::string path = "joints." + name;
    const files::Place place(node.source());
    std::string file;
    if (const auto* text = node.as_string()) {
        file = text->get();
    } else if (const auto* table = node.as_table()) {
        files::complain_unknown_keys(*table, entry_keys, path, complaints);
        files::read_text_at(*table, "file", path, file, complaints);
        files::read_text_at(*table, "name", path, joint.in_log, complaints);
    } else {
        complaints.add(place, path, "is " + files::describe(node) + ", expected a joint file or { file, name }");
        return joint;
    }
    if (!can_be_folder(name))
        complaints.add(place, path,
                       "becomes a folder of the answer: expected letters, digits, _ - + and ., not first; { file, "
                       "name } gives a joint another name in the log");
    if (file.empty()) complaints.add(place, path, "has no file, expected its joint file");
    joint.file = folder / file;
    return joint;
}

RobotJoints read_file(const std::filesystem::path& file)
{
    const toml::table root = files::parse_toml(files::read_text(file), file.string());
    if (!root.contains("joints"))
        throw BadInput(file.string() + ": has no table [joints], expected lines such as elbow = \"elbow.toml\" in it");
    files::Complaints complaints(file.string());
    files::complain_unknown_keys(root, top_keys, "", complaints);
    RobotJoints robot{"", file, root.contains("record"), {}};
    files::read_text_at(root, "title", "", robot.title, complaints);
    if (const auto* joints = files::table_at(root, "joints", "", complaints))
        for (const auto& [name, node] : files::in_file_order(*joints))
            robot.joints.push_back(read_entry(name, *node, file.parent_path(), complaints));
    if (complaints.empty() && robot.joints.empty())
        complaints.add({}, "joints", "names no joint, expected lines such as elbow = \"elbow.toml\"");
    complain_shared_names(robot, complaints);
    complaints.throw_if_any();
    return robot;
}

RobotJoints read_folder(const std::filesystem::path& folder)
{
    RobotJoints robot{"", folder, false, {}};
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto& file = entry.path();
        if (file.extension() != ".toml" || file.filename() == "record.toml") continue;
        const std::string name = file.stem().string();
        if (!can_be_folder(name))
            throw BadInput(file.string() +
                           ": its name becomes a folder of the answer: expected letters, digits, _ - + and .");
        robot.joints.push_back({name, name, file});
    }
    if (robot.joints.empty())
        throw BadInput(folder.string() + ": has no joint files, expected one NAME.toml for each joint");
    std::sort(robot.joints.begin(), robot.joints.end(),
              [](const RobotJointFile& a, const RobotJointFile& b) { return a.name < b.name; });
    return robot;
}

}  // namespace

RobotJoints read_robot_joints(const std::filesystem::path& source)
{
    if (!std::filesystem::is_directory(source)) return read_file(source);
    const auto robot = source / "robot.toml";
    return std::filesystem::exists(robot) ? read_file(robot) : read_folder(source);
}

bool is_robot(const std::filesystem::path& source)
{
    if (std::filesystem::is_directory(source)) return true;
    if (!std::filesystem::exists(source)) return false;
    try {
        return files::parse_toml(files::read_text(source), source.string()).contains("joints");
    } catch (const BadInput&) {
        return false;  // who reads it as a joint says what is wrong with it
    }
}

}  // namespace stickslip
