// One joint's records out of a log of several joints: a table, a folder of tables, or what the Python readers know.
#pragma once
#include "sweep/files/records/record_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// Whose records are wanted, and what says how columns are called.
struct LoggedJoint {
    std::string name;                  ///< in the log
    std::filesystem::path joint_file;  ///< with its [record], where it has one
    std::filesystem::path robot_file;  ///< the same for all joints; may be empty
};

/// Settings of the readers of foreign logs, as `stickslip convert` takes them.
struct LogOptions {
    std::string topic, command, time, group, episode;
};

struct JointLog {
    std::vector<RecordReading> records;
    std::string absent;  ///< why there are none: the log has other joints
};

/// Reads a .csv or .csv.gz with columns of several joints (see joint_columns); a folder with NAME.csv (or .csv.gz) or
/// NAME/*.csv for each joint; any other log through `python3 -m stickslip.convert`. Throws BadInput for what cannot be
/// read.
JointLog read_joint_log(const std::filesystem::path& log, const LoggedJoint& wanted, const Joint& joint,
                        const LogOptions& options = {});

/// Its last part, also of a folder that was given with a slash at its end.
std::string name_of_log(const std::filesystem::path& log);

/// A folder that is a log itself: SAGE's, or a bag of ROS 2.
bool is_folder_of_a_log(const std::filesystem::path& folder);

/// A format that the Python readers know, or a folder.
bool is_foreign_log(const std::filesystem::path& log);

/// Whether the program reads the file itself: .csv or .csv.gz.
bool is_table(const std::filesystem::path& file);

}  // namespace stickslip
