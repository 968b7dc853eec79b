// A judged ladder in the words of an answer.
#pragma once
#include "analysis/diagnosis/verdict/findings.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// Rungs, corrections, what is explainable and what remains. `audited` is the share of the gap that correcting the
/// controller and the encoder takes: it is the first rung where the audit found something, and the others share the
/// rest.
void report_ladder(const Prepared& prepared, const Findings& findings, double audited, Diagnosis& d);

/// The ladder's causes, then the rivals of its first rung and those that cannot be distinguished from a further one,
/// each as a whole set with the other rungs: none is likelier than the first.
std::vector<Cause> causes_of(const Prepared& prepared, const JudgedLadder& judged);

/// A set that was judged in the place of one of the ladder's rungs.
struct RungRival {
    std::size_t rung = 0;
    const FittedSet* set = nullptr;
    const FittedSet* named = nullptr;               ///< with the other causes of the ladder, where that was fitted
    double odds = 0;                                ///< against the rung
    std::vector<std::string> names;                 ///< all named causes, with the rival's in place of the rung's
    std::pair<std::string, std::string> separates;  ///< the rung's cause and the rival's
};

/// Of all rungs, in their order.
std::vector<RungRival> rivals_of(const JudgedLadder& judged);
/// Those that these records cannot distinguish from the rung.
std::vector<RungRival> indistinguishable(const JudgedLadder& judged);
/// Probability that all rungs are right, and the document's numbers that count as rungs.
double chance_of_all(const JudgedLadder& judged);

}  // namespace stickslip::gap
