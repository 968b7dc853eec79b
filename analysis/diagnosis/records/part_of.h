// A part of a record that is already on its clock.
#pragma once
#include "analysis/diagnosis/records/ticks.h"

namespace stickslip::gap {

/// The ticks [from, to) with their own times and jumps. How it starts is not known from before `from`: at rest, as far
/// as this goes.
Ticks part_of(const Ticks& whole, std::size_t from, std::size_t to);

}  // namespace stickslip::gap
