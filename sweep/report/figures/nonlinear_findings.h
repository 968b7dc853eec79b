// What a nonlinear sweep has against its own linear chart, in words.
#pragma once
#include "sweep/study/large_disturbances.h"

#include <span>
#include <string>

namespace stickslip {

/// Mark-up: one paragraph; empty without a bistable point.
std::string large_disturbances_text(const Slice& slice, const LargeDisturbances& found, Units units);

/// Mark-up: how the numbers of limit cycles at the points of a chart came about, followed or interpolated. No full
/// stop.
std::string followed_text(std::span<const MapReading> readings);

}  // namespace stickslip
