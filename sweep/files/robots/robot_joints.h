// The joints of a robot, each with its joint file: what a diagnosis of all joints goes through.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

struct RobotJointFile {
    std::string name;            ///< also the folder of its answer
    std::string in_log;          ///< what logs call it
    std::filesystem::path file;  ///< its joint file
};

struct RobotJoints {
    std::string title;                   ///< may be empty
    std::filesystem::path source;        ///< the file, or the folder
    bool has_record = false;             ///< the file has a [record] table, which holds for every joint
    std::vector<RobotJointFile> joints;  ///< in the order of the file; of a folder by name
};

/// Reads
///   title = "arm 3"
///   [joints]
///   shoulder = "shoulder.toml"                             # from the folder of this file
///   elbow = { file = "elbow.toml", name = "joint_3" }      # a log that calls it otherwise
///   [record.columns]
///   position = { name = "{joint}/angle", unit = "deg" }    # {joint} stands for the name in the log
/// or takes every *.toml of a folder as the joint of its name (a robot.toml in it says which instead). Throws BadInput.
RobotJoints read_robot_joints(const std::filesystem::path& source);

/// Whether the path is read by read_robot_joints: a folder, or a file with a table [joints].
bool is_robot(const std::filesystem::path& source);

}  // namespace stickslip
