// Findings in the words of an answer: every cause with its numbers, its signature and how sure it is.
#pragma once
#include "analysis/diagnosis/verdict/findings.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// A fitted candidate, with what the controller's audit found beside it. The first `corrections` effects are numbers of
/// the document that were refitted, and no part of the cause.
Cause cause_of(const Prepared& prepared, const Attribution& attribution, double probability,
               std::size_t corrections = 0);

/// Names of causes with what the audit found, which belongs to every set.
std::vector<std::string> with_findings(const Prepared& prepared, const std::vector<std::string>& causes);

}  // namespace stickslip::gap
