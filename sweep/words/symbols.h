// How a parameter is written on a chart and called in a sentence.
#pragma once
#include "analysis/results/quantity.h"

#include <string>
#include <string_view>

namespace stickslip {

/// Chart mark-up of the parameter at a dotted path: "control.k_p" → "k_{p}", "friction.L.1" → "L_{2}". Paths without an
/// entry are written by their last key: its part behind the first underscore becomes the index. Inertias of a revolute
/// joint are J, of a prismatic one m.
std::string symbol_of(std::string_view path, Units units);

/// Words for the same: "control.k_p" → "position gain". Paths without an entry read as their last two keys.
std::string name_of(std::string_view path);

}  // namespace stickslip
