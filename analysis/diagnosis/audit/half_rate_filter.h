// The filter behind velocities that were logged at every second tick, without a grid that the readings between would
// have to lie on. Internal to analysis/diagnosis/audit.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <optional>

namespace stickslip::gap {

/// Shares T/(τ + T) that a filter may have. The ends agree where the joint moves by much more than its noise.
struct FilterShares {
    double by_motion;  ///< if what two neighbouring ticks differ by is none of what the velocity before had in it
    double by_noise;   ///< if all that is seen is white noise of the readings
};

/// v_k = (1−g)² v_{k−2} + g(1−g) d_{k−1} + g d_k, d the rates from tick to tick. Of these only the mean d̄ of both is
/// known: v_k − d̄ on v_{k−2} − d̄ has the slope (1−g)², less what noise of the reading at k − 2 puts into both. Nothing
/// where fewer than a hundred rows tell it, or where the slope is not that of a filter.
std::optional<FilterShares> filter_shares_of_halves(const std::vector<Case>& cases);

/// The slope that white noise of the readings alone would give with a filter of this share.
double slope_of_noise(double share);

}  // namespace stickslip::gap
