// The numbers of a joint with its causes in it, as engineers use them.
#pragma once
#include "analysis/diagnosis/verdict/findings.h"
#include "analysis/diagnosis/verdict/quality.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// Those of the documented numbers that the causes change, corrections included, each with its 95 % interval: the
/// errors of all fitted numbers carried through.
std::vector<SheetValue> sheet_values(const Prepared& prepared, const Attribution& attribution, const Quality& quality,
                                     std::size_t corrections);

/// The same of what the audit of the controller and of the readings found.
std::vector<SheetValue> sheet_values_of_findings(const Prepared& prepared);

/// Whether a cause of this form changes a number that a data sheet has.
bool has_sheet_value(const Effect& effect, const EffectForm& form);

}  // namespace stickslip::gap
