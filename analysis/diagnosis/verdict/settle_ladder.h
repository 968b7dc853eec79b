// What is taken from a ladder, or put in its place, once it is judged.
#pragma once
#include "analysis/diagnosis/ladder/ladder.h"
#include "analysis/diagnosis/verdict/judge_ladder.h"

namespace stickslip::gap {

struct Settling {
    const std::vector<Attribution>& pairs;
    const OnlyNoise& only_noise;
    const std::vector<Joint>& documented;  ///< before the audit
    int runs;                              ///< of each simulation
};

/// Takes rungs away that are small, unlikely, or push whole records away, and holds what is left against numbers over
/// one scale.
void settle_ladder(LadderSearch& search, const Fit& fit, const Settling& with, JudgedLadder& j);

}  // namespace stickslip::gap
