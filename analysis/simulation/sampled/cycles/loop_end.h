// Where a motion in a sampled loop ends.
#pragma once
#include "analysis/results/point.h"

namespace stickslip {

/// Cycles of a sampled loop are not periodic in ticks: amplitude and period are means over many turns, extrema of the
/// velocity the outermost of them.
struct LoopEnd {
    enum class Kind { steady, cycle, period_n, irregular, held, undecided };
    Kind kind = Kind::undecided;
    Reason reason = Reason::none;
    double amplitude = missing, period = missing, velocity_min = missing, velocity_max = missing;
    double stick_fraction = missing;
    double amplitude_spread = 0;  ///< from turn to turn, per amplitude: largest less smallest
    double jitter =
        missing;  ///< standard deviation of the amplitude where an encoder or noise disturbs it, or turns are not alike
    double first_peak = missing;  ///< largest position excess of the first turn
    double cycle_peak = missing;  ///< the same of the turns that amplitude is taken from, of cycles only
    bool reversed = false;
    int turns = 0;           ///< that were followed
    int repeats = 1;         ///< turns after which a period-n motion repeats
    bool cut_short = false;  ///< undecided because the work was spent

    bool oscillates() const { return kind != Kind::steady && kind != Kind::undecided; }
    Outcome outcome() const;
};

}  // namespace stickslip
