// The symbols of units, their dimensions and prefixes. Internal to sweep/files/text.
#pragma once
#include "sweep/files/text/units.h"

#include <optional>
#include <string_view>

namespace stickslip {

std::optional<Unit> unit_named(std::string_view name);

}  // namespace stickslip
