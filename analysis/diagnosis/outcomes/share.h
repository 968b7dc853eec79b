// How the rows are shared out: what a law explains of them, and where the nominal joint is wrong. Internal.
#pragma once
#include "analysis/diagnosis/outcomes/explain.h"

namespace stickslip::gap {

/// Whether the rows distinguish a law from a better one, by policy::clear_margin.
bool distinguished(const LawFit& better, const LawFit& other);

/// A fitted law as a cause; `other_kind` is the best law with memory where this one has none, and the reverse.
Cause cause_of(const OutcomeAnswer& answer, const LawFit& fit, const LawFit* other_kind);

/// Fills the shares by signal and by settings, and the gap before and after the winner, from held-out rows.
void locate(OutcomeAnswer& answer);

}  // namespace stickslip::gap
