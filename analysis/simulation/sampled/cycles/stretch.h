// A stretch of a motion that no turn divides.
#pragma once
#include "analysis/results/point.h"
#include "analysis/simulation/sampled/cycles/turns.h"

namespace stickslip {

/// Its outermost extrema, time at rest, times that it came to rest, and the rounds that it ended: from one rise of the
/// position to the next, by more than jitter makes.
struct Stretch {
    LoopTurn outer;
    long ticks = 0;
    int rests = 0, rounds = 0;
    double sizes = 0, squares = 0;  ///< of the rounds' amplitudes: sums of them and of their squares
    double changes = 0;             ///< sum of the squares of their changes from round to round
    double first_round = missing, last_round = missing;  ///< s, when they ended

    void add(const Stretch& more);
    bool smooth() const { return outer.rest_time == 0 && !outer.reversed; }
    /// Mean amplitude of the rounds, where there are some.
    double size() const { return rounds > 0 ? sizes / rounds : outer.amplitude(); }
    double spread() const;  ///< standard deviation of the rounds' amplitudes
};

}  // namespace stickslip
