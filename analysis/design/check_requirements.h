// Whether requirements of a design make sense for its joint. Internal to analysis/design.
#pragma once
#include "analysis/design/design.h"

namespace stickslip {

void check_sense(const Joint& joint, const Requirements& r);

}  // namespace stickslip
