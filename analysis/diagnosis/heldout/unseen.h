// The gap on the rows of long records that no fit has seen.
#pragma once
#include "analysis/diagnosis/audit/stretches.h"
#include "analysis/diagnosis/heldout/heldout.h"

namespace stickslip::gap {

/// Simulates the closed loop along the records before and after, and compares all rows outside the stretches that
/// `found` was fitted to. Halfway to the next stretch holds what belongs to one alone, as the phase of a disturbance.
/// `documented` holds the joint of each stretch before the audit.
HeldOut hold_out_rest(const std::vector<Case>& whole, const std::vector<StretchOf>& stretches, const Fit& fit,
                      const std::vector<Joint>& documented, const Attribution& found, int runs);

}  // namespace stickslip::gap
