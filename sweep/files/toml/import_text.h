// joint.toml of an imported joint.
#pragma once
#include "sweep/study/import/import.h"

#include <string>

namespace stickslip {

/// With comments that say where each number comes from and which are still to be filled in.
std::string import_text(const ImportAnswer& answer, const std::string& robot_file, const std::string& pose_file);

}  // namespace stickslip
