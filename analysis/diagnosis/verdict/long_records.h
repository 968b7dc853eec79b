// Long records: stretches of them are fitted, and the gap is that of all other rows.
#pragma once
#include "analysis/diagnosis/heldout/heldout.h"
#include "analysis/diagnosis/verdict/findings.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// Puts stretches in the place of records that are too long to be fitted as a whole, and writes down which.
void take_stretches(Prepared& prepared, Diagnosis& d);

/// The gap on held-out data: records in their turn, or of long ones the rows that were not fitted.
HeldOut held_out(const Prepared& prepared, const ParallelFor& parallel, const Attribution& found, int runs);

}  // namespace stickslip::gap
