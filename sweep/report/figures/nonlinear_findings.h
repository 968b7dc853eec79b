// What a nonlinear sweep has against its own linear chart, in words.
#pragma once
#include "sweep/study/large_disturbances.h"

#include <span>
#include <string>
#include <vector>

namespace stickslip {

/// Mark-up: one paragraph; empty without a bistable point.
std::string large_disturbances_text(const Slice& slice, const LargeDisturbances& found, Units units);

/// The numbers of limit cycles alone: rest for good is none. `rests` as rests_of() tells it.
std::vector<double> cycle_values(const MapReading& reading, const std::vector<bool>& rests);

/// What a place without a limit cycle stands for.
std::string none_reached(const std::vector<bool>& rests);

/// Mark-up: how the numbers of limit cycles at the points of a chart came about, followed or interpolated. No full
/// stop.
std::string followed_text(std::span<const MapReading> readings);

}  // namespace stickslip
