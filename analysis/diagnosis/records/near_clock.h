// Logs whose clock shows the time of day, or the seconds since 1970.
#pragma once
#include "analysis/diagnosis/records/record.h"

#include <vector>

namespace stickslip::gap {

/// Whether one starts so far from zero that its stamps have lost digits: the seconds since 1970 are doubles 0.24 µs
/// apart, a noticeable part of a tick.
bool any_far_clock(const std::vector<Record>& records);

/// The records on far clocks counted from the first row of all of them; stamps that are even to the digits that they
/// have are even.
std::vector<Record> on_near_clocks(std::vector<Record> records);

}  // namespace stickslip::gap
