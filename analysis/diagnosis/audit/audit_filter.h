// What logged velocities say of the controller's filter, which computed them.
#pragma once
#include "analysis/diagnosis/audit/audit.h"

namespace stickslip::gap {

/// Where velocities were logged at every tick, and no command, v_k − v_{k−1} = g (d_k − v_{k−1}) gives g = T/(τ + T) by
/// least squares, exactly; plain differences (g = 1) say nothing against a documented filter. At every second tick the
/// time constant is right that puts the readings between the rows onto the grid of the encoder; where none does, these
/// readings are interpolated. Without a grid they say it roughly (half_rate_filter.h): then only a filter that is none
/// of those is a finding. Corrects the joints (and the readings between the rows), adds what it finds, and says in
/// `filter_seen` whether the velocities follow a filter. Velocities of a filter of two poles that commands up to
/// `limit` are made of are believed from then on. Records that document different filters are left.
void audit_filter(std::vector<Case>& cases, double limit, Audit& result);

/// Whether the logged velocities are filtered differences of the readings, with a filter of any time constant.
bool velocities_follow_a_filter(const std::vector<const Case*>& cases);

}  // namespace stickslip::gap
