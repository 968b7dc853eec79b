// Where a motion in a sampled loop ends: steady sliding, a cycle, something longer, or a reason why it is not known.
#pragma once
#include "analysis/simulation/sampled/loop_mode.h"
#include "analysis/simulation/sampled/turns.h"

namespace stickslip {

struct LoopFollowOptions {
    int turn_limit = 3000;
    bool steady_attracts = false;  ///< small disturbances decay
    double turn = missing;         ///< s, of the slow mode: about how long a turn is
    double held = 0;               ///< s, that a cycle may stand still
    double decay = missing;        ///< 1/s, of small disturbances; negative where they decay
    bool uneven = false;           ///< encoder or noise: no motion repeats, turns are no measure
};

/// Cycles of a sampled loop are not periodic in ticks: amplitude and period are means over many turns, extrema of the
/// velocity the outermost of them.
struct LoopEnd {
    enum class Kind { steady, cycle, period_n, irregular, held, undecided };
    Kind kind = Kind::undecided;
    Reason reason = Reason::none;
    double amplitude = missing, period = missing, velocity_min = missing, velocity_max = missing;
    double stick_fraction = missing;
    double amplitude_spread = 0;  ///< from turn to turn, per amplitude: largest less smallest
    double first_peak = missing;  ///< largest position excess of the first turn
    bool reversed = false;
    int turns = 0;    ///< that were followed
    int repeats = 1;  ///< turns after which a period-n motion repeats

    bool oscillates() const { return kind != Kind::steady && kind != Kind::undecided; }
    Outcome outcome() const;
};

/// Follows the loop from where it is. `steady` is its state in steady sliding, empty where it has none.
LoopEnd follow_loop(SampledLoop& loop, const std::vector<double>& steady, double origin,
                    const LoopFollowOptions& options);

}  // namespace stickslip
