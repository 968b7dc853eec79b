// Which joint of which robot: a pose, and the [robot] table of a spec.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/study/import/robot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// One coordinate a joint: what the file names (joint = value, with units or without), the reference elsewhere.
/// An empty path: all at their reference. Throws BadInput for what is no joint of the robot.
std::vector<double> read_pose(const Robot& robot, const std::filesystem::path& file);

namespace files {

/// Gives the joint the pose, inertia and gravity that it has in the robot of a spec's [robot] table, if there is one.
void read_robot_table(const toml::table& spec, const std::filesystem::path& folder, Joint& joint,
                      Complaints& complaints);

}  // namespace files
}  // namespace stickslip
