// The least stable velocity of a choice of gains, wherever one is shown.
#pragma once
#include "analysis/results/quantity.h"

#include <string>

namespace stickslip {

/// "≤" where the search ended, at `lowest`, before an unstable one.
std::string least_velocity_text(double least, double lowest, Units units);

}  // namespace stickslip
