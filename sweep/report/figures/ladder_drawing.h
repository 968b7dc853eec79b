// The ladder of causes as a waterfall: from the whole gap down, rung by rung, to what remains.
#pragma once
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

namespace stickslip {

/// A floating bar a step: the document's numbers corrected, every cause given those above it with its interval, and
/// what remains; a line where the explainable part ends.
Figure ladder_figure(const Diagnosis& d);

}  // namespace stickslip
