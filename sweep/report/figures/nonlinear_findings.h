// What a nonlinear sweep has against its own linear chart, in words.
#pragma once
#include "sweep/study/large_disturbances.h"

#include <string>

namespace stickslip {

/// Mark-up: one paragraph; empty without a bistable point.
std::string large_disturbances_text(const Slice& slice, const LargeDisturbances& found, Motion motion);

}  // namespace stickslip
