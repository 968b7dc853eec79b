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

}  // namespace stickslip::gap
