// Integral action, dead zone and feed-forward in the logged command, documented or not.
#pragma once
#include "analysis/diagnosis/audit/audit.h"

namespace stickslip::gap {

/// Compares the command with the documented controller and with one to three of its terms changed: gains, integral,
/// feed-forward, dead zone; the fewest changes that leave no more than all of them do are findings, and the joints are
/// corrected. Takes over where the document has such terms, or where only such terms explain what plain gains do not;
/// true then.
bool audit_terms(std::vector<Case>& cases, double limit, Audit& result);

}  // namespace stickslip::gap
