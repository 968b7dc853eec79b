// Neighbours whose mode lies near the frequency of friction, in words.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "analysis/stability/neighbour_modes.h"

#include <string>

namespace stickslip {

/// "Neighbour 1 vibrates at 63.2 rad/s, within 30 % of …": one sentence, for the terminal and the page.
std::string near_mode_text(const NearMode& mode, Units units);

/// The same as an alert of a page.
Alert near_mode_alert(const NearMode& mode, Units units);

}  // namespace stickslip
