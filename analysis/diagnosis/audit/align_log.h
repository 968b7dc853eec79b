// A log against the controller that its command came from: columns that are late, early or scaled.
#pragma once
#include "analysis/diagnosis/audit/audit.h"

namespace stickslip::gap {

/// Shifts the reference by whole control periods, or divides positions and velocities by one factor, where the logged
/// command then is the controller's, up to its gains, and as logged is not: a logger that reads the set point before or
/// after the loop does, or converts by another gear ratio, says nothing of the machine. Of k_p and k_v alone, on every
/// tick of the loop; the result gets a note of what was done.
void align_log(std::vector<Case>& cases, double limit, Audit& result);

}  // namespace stickslip::gap
