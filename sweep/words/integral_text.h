// The price of integral action in words.
#pragma once
#include <string>

#include "analysis/joint/joint.h"
#include "analysis/stability/integral_cost.h"

namespace stickslip {

/// "Your k_i of 1 MN/(m·s) costs 30 % of the margin: …".
std::string integral_text(const IntegralCost& cost, Units units);

}  // namespace stickslip
