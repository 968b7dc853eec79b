// Where the gap lies: by stage of the chain, and by regime of the motion.
#pragma once
#include "analysis/gap/ensemble.h"

namespace stickslip::gap {

/// Shares of the three stages reference → command → effort → motion: what each gets wrong when it is fed with the
/// measured signals before it, all expressed as an effort on the mechanism, so that they can be compared. `documented`
/// holds the joints before the audit corrected them.
std::vector<Share> locate_signals(const std::vector<Case>& cases, const std::vector<Joint>& documented);

/// Shares of the motion's gap by regime. Speed regimes (stuck, low speed, sliding) exclude each other, the rest
/// overlap.
std::vector<Share> locate_regimes(const std::vector<Case>& cases);

}  // namespace stickslip::gap
