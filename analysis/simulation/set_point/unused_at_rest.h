// What of a joint's description no answer at a set point contains.
#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint.h"

namespace stickslip {

/// Keys that are set and that no answer at rest reads.
std::vector<std::string> unused_at_rest(const Joint& joint);

}  // namespace stickslip
