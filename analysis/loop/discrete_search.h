// Roots of a sampled loop, every gain at which they cross the unit circle, and the margins of the loop.
#pragma once
#include <complex>
#include <vector>

#include "analysis/base/crossing.h"
#include "analysis/loop/command_margins.h"
#include "analysis/loop/discrete_loop.h"

namespace stickslip {

/// Multipliers with the gain closed, by falling size.
std::vector<std::complex<double>> multipliers(const DiscreteLoop& loop, double gain);

/// max ln|z| / T with the gain closed; 0 where only rounding is left of it, NaN where the loop is not finite.
double sampled_growth(const DiscreteLoop& loop, double gain);

/// Every crossing of the unit circle with a gain > 0, ascending in the gain; `doubtful` are bands of ω in which a touch
/// could not be excluded.
struct CircleCrossings {
    std::vector<Crossing> crossings;
    std::vector<Interval> doubtful;
    bool searched = true;  ///< false: the poles and zeros of T, by which bands are excluded, are not known
};

/// 1 + g T(z) = 0 on |z| = 1. The phase of T turns by what its poles and zeros turn, each monotone but for half the
/// angle itself, so that a band is cleared where their turns cannot carry T to the negative axis, and holds one
/// crossing where all of them together turn one way.
CircleCrossings circle_crossings(const DiscreteLoop& loop);

/// The open intervals of the gain in which all multipliers decay, decided between neighbouring crossings.
std::vector<Interval> stable_gains(const DiscreteLoop& loop, const std::vector<Crossing>& crossings, double own);

/// The loop opened at the command, `turned` being all of its gains and `base` none.
CommandMargins command_margins(const DiscreteLoop& loop);

}  // namespace stickslip
