// Robots from URDF and MJCF.
#pragma once
#include "sweep/study/import/robot.h"

#include <filesystem>

namespace stickslip {

/// URDF or MJCF, distinguished by its outermost element. Throws BadInput with file:line for what it cannot use: loops,
/// moving bodies without inertia, elements that would change the mechanism and are not known.
Robot read_robot(const std::filesystem::path& file);

/// Index of the joint of this name; throws BadInput with the nearest names.
int joint_named(const Robot& robot, const std::string& name, const std::string& source);

/// One coordinate a joint: what the file names (joint = value, with units or without), the reference elsewhere.
/// An empty path: all at their reference.
std::vector<double> read_pose(const Robot& robot, const std::filesystem::path& file);

namespace files {

Robot read_urdf(const std::filesystem::path& file);
Robot read_mjcf(const std::filesystem::path& file);

}  // namespace files
}  // namespace stickslip
