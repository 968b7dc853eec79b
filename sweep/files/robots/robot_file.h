// Robots from URDF and MJCF.
#pragma once
#include "sweep/study/import/robot.h"

#include <filesystem>

namespace stickslip {

/// URDF or MJCF, distinguished by its outermost element. Throws BadInput with file:line for what it cannot use: loops,
/// moving bodies without inertia, elements that would change the mechanism and are not known.
Robot read_robot(const std::filesystem::path& file);

/// The same of a text that includes no files; `name` is what messages call it.
Robot read_robot_text(const std::string& text, const std::string& name);

/// The description as one text, included files in their places. Throws BadInput where it cannot be read.
std::string robot_text(const std::filesystem::path& file);

/// Index of the joint of this name; throws BadInput with the nearest names.
int joint_named(const Robot& robot, const std::string& name, const std::string& source);
}  // namespace stickslip
