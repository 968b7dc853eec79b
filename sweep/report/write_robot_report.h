// The page of a robot as a file.
#pragma once
#include "sweep/report/pages/robot_report.h"

#include <filesystem>

namespace stickslip {

/// Writes robot.html into the directory and returns its path. Throws std::filesystem::filesystem_error.
std::filesystem::path write_robot_report(const RobotPage& page, const std::filesystem::path& directory);

}  // namespace stickslip
