// What a sampled loop cannot remember, with the number that was given. Internal to sweep/files.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/joint/parameters.h"

namespace stickslip::files {

/// Dead time or averaged readings of more ticks than a loop may remember: on one key, its path and message, empty where
/// they are allowed. The rules of Control and Joint, which know no places and no text of numbers. Of a control table
/// whose joint is not yet read, `sensor_delay` is 0.
Problem refused_memory(const Control& control, double sensor_delay);

}  // namespace stickslip::files
