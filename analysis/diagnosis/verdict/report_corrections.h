// What corrections of the document a ladder needs, and which of them matter. Internal to analysis/diagnosis/verdict.
#pragma once
#include "analysis/diagnosis/verdict/findings.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// The corrections of a fit as numbers of the document.
std::vector<Correction> corrections_of(const Prepared& p, const JudgedLadder& j);

/// The correction that is largest against its prior.
std::vector<std::string> furthest_off(const JudgedLadder& j);

/// Which corrections, left out, cost a part of what all of them take.
std::vector<std::string> that_matter(const Prepared& p, const JudgedLadder& j);

/// What of the gap all numbers of the document together take that are causes.
double taken_by_numbers(const JudgedLadder& j);

/// No cause, but numbers that the document has wrong, and fewer of them where the records divide them as well.
std::vector<Cause> numbers_alone(const Prepared& p, const JudgedLadder& j);

}  // namespace stickslip::gap
