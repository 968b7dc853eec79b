// How fast a loop at a set point moves on where dry friction is left out.
#pragma once
#include "analysis/simulation/set_point/regulator.h"

namespace stickslip {

/// Time constants of the loop without dry friction and delay, slow ones first; the slowest is a creep where its root is
/// real.
struct LoopTimes {
    double slow = 0, next = 0;
    bool creeps = false;
};

LoopTimes times_of(const Regulator& regulator, double viscous);

}  // namespace stickslip
