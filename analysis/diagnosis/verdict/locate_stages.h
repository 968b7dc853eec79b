// Where the gap lies: by stage of the chain, and by regime of the motion.
#pragma once
#include "analysis/diagnosis/heldout/ensemble.h"

namespace stickslip::gap {

/// Shares of the three stages reference → command → effort → motion: what each gets wrong when it is fed with the
/// measured signals before it, all expressed as an effort on the mechanism, so that they can be compared. `documented`
/// holds the joints before the audit corrected them.
std::vector<Share> locate_signals(const std::vector<Case>& cases, const std::vector<Joint>& documented);

/// Share of the effort stage: where the measured effort drives the joint no loop is closed, and what the controller
/// does is a share of the forces.
double share_of_controller(const std::vector<Share>& signals);

/// Shares of the motion's gap by regime. Speed regimes (stuck, low speed, sliding) exclude each other and are the
/// whole, the rest overlap: reversal, direction, acceleration, saturation, thirds of the positions, light and heavy
/// load (effort below a third and above two thirds of its 95th percentile), early and late third of a record, cold and
/// warm third where a temperature was logged. Last come bands of frequency, which are a whole of their own: of the
/// prediction error at 50 rad/s, which holds little of what is slower than that.
std::vector<Share> locate_regimes(const std::vector<Case>& cases);

}  // namespace stickslip::gap
