// From prepared records to causes: singles, then pairs, then what predicts unseen data, then unmodelled forces.
#pragma once
#include "analysis/diagnosis/verdict/findings.h"
#include "analysis/diagnosis/verdict/stage_meter.h"

namespace stickslip::gap {

/// Looks for what explains the records; `pair_partners` of the best singles look for a partner, and whole records are
/// simulated `runs` times each. A jump of the reference
/// that lies elsewhere once an effect is known is moved in the cases. What was found stays in the findings where the
/// search is interrupted.
void find_causes(Prepared& prepared, std::size_t pair_partners, int runs, StageMeter& meter,
                 const ParallelFor& parallel, Findings& findings);

}  // namespace stickslip::gap
