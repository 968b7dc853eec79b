// Verdicts tested by simulations of whole records: a cause that does not improve held-out data is rejected, however
// well it fits, and a joint that is far from its records has a gap.
#pragma once
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// What was known of the named cause before it was simulated.
struct Standing {
    /// Its predictions explain to within noise, the controller's audit found it, or a cross-validated comparison.
    bool settled = false;
    bool noise_documented = false;  ///< noise floors are the documented ones
    bool predicted = false;         ///< its rungs were judged by predictions of rows that their fits had not seen
    std::size_t findings = 0;       ///< rungs at the head of the ladder that the controller's audit found
};

/// The verdict becomes `unknown` if the named cause enlarges the gap on held-out data, if the only cause of a ladder is
/// less likely than none of the catalogue, or if an unsettled cause leaves more than half of the gap, many times an
/// undocumented noise floor, or a residual in spite of implausible parameters. The
/// reasons say why, `ambiguous_with` is emptied, the ranking stays. A ladder of predictions stays, too, where only the
/// simulation of whole records gets worse: what was gained from row to row was gained, though it names no cause. An
/// unsettled cause that leaves more than a documented noise has a lower probability, and so has one that explains much
/// less of simulated records than of predicted rows; the reasons say why, and rungs are no surer than their set.
/// Returns whether the cause was rejected.
bool reject_if_not_validated(Diagnosis& diagnosis, const Standing& standing);

/// A verdict of no gap becomes `unknown` if the simulation of whole records is far from them: noise may hide from row
/// to row what adds up over a record. The last reason says so. Returns whether it did.
bool reject_no_gap(Diagnosis& diagnosis);

}  // namespace stickslip::gap
