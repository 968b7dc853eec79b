// The stable gains of a joint whose sliding moves with k_p: its roots followed from gain to gain.
#pragma once
#include "analysis/stability/stable_gains.h"

namespace stickslip {

/// Within `range`, which holds the joint's own k_p, the joint is linearised anew at each gain, with delays or tables
/// over delayed_gain_decades to either side at most, as roots are counted at each. A step is taken where the slopes of
/// the roots at both its ends foretell each of them to within its distance from the axis, else halved; changes are then
/// located. What moves a root to the axis and back within a step without showing in the slopes at its ends can be
/// missed. A search that costs more than `work::places_of_gain_scan` times the effort ends earlier: `searched_from` and
/// `searched_to`.
StableGains scan_gains(const Joint& joint, Theory theory, Interval range);

/// Over gain_decades to either side of the joint's own k_p.
StableGains scan_gains(const Joint& joint, Theory theory);

inline constexpr double gain_decades = 6, delayed_gain_decades = 3;

}  // namespace stickslip
