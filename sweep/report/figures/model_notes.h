// What stands under the drawing of a joint: its loop, its friction, springs that harden. Internal to
// sweep/report/figures.
#pragma once
#include "analysis/joint/joint.h"

#include <string>
#include <vector>

namespace stickslip {

/// Each a line. `reduction` says what the values of a geared motor are at, and may be empty.
std::vector<std::string> model_notes(const Joint& joint, const std::string& reduction);

}  // namespace stickslip
