// Findings in the words of an answer: every cause with its numbers, its tell-tale and how sure it is.
#pragma once
#include "analysis/diagnosis/verdict/findings.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// A fitted candidate, with what the controller's audit found beside it.
Cause cause_of(const Prepared& prepared, const Attribution& attribution, double probability);

/// What a contest has ranked, best first: held-out log RMS against each other, and a chance that it is none of them.
/// The refitted numbers of the joint are no part of a cause.
std::vector<Cause> causes_of(const Prepared& prepared, const Contest& contest);

}  // namespace stickslip::gap
