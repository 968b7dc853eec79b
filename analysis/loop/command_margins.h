// How far a loop is from its boundary, opened at the command: the same for every kind of loop.
#pragma once
#include <complex>
#include <functional>
#include <vector>

#include "analysis/base/crossing.h"

namespace stickslip {

/// NaN where there is none. Of an unstable loop both margins are negative: what the loop lacks. It lacks no gain where
/// no factor on all gains makes it stable.
struct CommandMargins {
    double gain_db = not_set;      ///< least change of the loop gain, either way, that reaches the boundary
    double phase_deg = not_set;    ///< at |L| = 1
    double lag = infinity;         ///< rad: least extra lag that reaches the boundary
    double crossover = not_set;    ///< rad/s, where that is
    double gain_below = 0;         ///< all gains may shrink to this part of themselves
    double gain_above = infinity;  ///< and grow by this factor
};

/// `crossings` in a factor on all gains and the factors of an unstable loop that are stable; L(iω) between two
/// frequencies: |L| = 1 is searched over a logarithmic scan.
CommandMargins command_margins(bool stable, const std::vector<Crossing>& crossings,
                               const std::vector<Interval>& stable_factors,
                               const std::function<std::complex<double>(double)>& L, double from, double to);

}  // namespace stickslip
