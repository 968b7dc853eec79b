// A dead time that is refused, with the number that was given. Internal to sweep/files.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/joint/parameters.h"

namespace stickslip::files {

/// The rules of Control and Joint, which know no places and no text of numbers, on one key: its path and message, empty
/// where they allow it. Of a control table whose joint is not yet read, `sensor_delay` is 0.
Problem refused_dead_time(const Control& control, double sensor_delay);

}  // namespace stickslip::files
