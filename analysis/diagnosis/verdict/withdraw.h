// Verdicts held against simulations of the whole: a cause that makes unseen data no better is none, however well it
// fits, and a joint that is far from its records has a gap.
#pragma once
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// What was known of the named cause before it was simulated.
struct Standing {
    /// Its predictions explain to within noise, the controller's audit found it, or a cross-validated comparison.
    bool settled = false;
    bool noise_documented = false;  ///< floors are those of the document
};

/// Where a named cause leaves a larger gap on held-out data than there was, the verdict becomes `unknown`; so it does
/// where an unsettled one leaves more than half of it, many floors that nobody documented, or a rest in spite of
/// implausible numbers. The reasons say why, and nothing is left to confuse it with; the ranking stays. An unsettled
/// one that leaves more than a documented noise is doubted. Whether the cause was withdrawn.
bool withdraw_if_no_better(Diagnosis& diagnosis, const Standing& standing);

/// Where there should be no gap, and the simulation of the whole records is far from them all the same, the verdict
/// becomes `unknown`, and the last reason says why: from row to row the noise may hide what adds up. Whether it did.
bool withdraw_no_gap(Diagnosis& diagnosis);

}  // namespace stickslip::gap
