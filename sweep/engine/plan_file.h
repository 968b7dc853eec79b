// The plan on disk: what `merge` and a resumed run need, without the spec it came from.
#pragma once
#include "sweep/engine/plan.h"

#include <string>
#include <string_view>

namespace stickslip {

/// JSON; axis values with as many digits as give the same bits back.
std::string to_json(const Plan& plan);

/// Reads what to_json wrote. Throws std::runtime_error if a field is missing or the content does not agree with its id.
Plan plan_from_json(std::string_view text);

/// The quantity that is written in this unit: the way back from a file to an axis. Units that several quantities share
/// (rad of a position and of an angle) give the first of them. Throws std::runtime_error for a unit of no quantity.
Quantity quantity_in(std::string_view unit, Units units);

}  // namespace stickslip
