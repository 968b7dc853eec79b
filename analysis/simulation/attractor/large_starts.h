// Where outcomes beside steady sliding are looked for.
#pragma once
#include <string_view>
#include <vector>
#include "analysis/results/detail.h"

#include "analysis/simulation/flows/delayed_flow.h"
#include "analysis/simulation/flows/mode.h"

namespace stickslip {

/// Disturbed states from which motions are followed until one does not come back, and what they are.
struct LargeStarts {
    std::vector<FlowVector> y;
    LargerTried tried = LargerTried::from_near_rest;
};

/// The start from near rest, always; pulls of the spring from either side, where friction with memory lets the mass
/// rest or turn back without losing that memory, as those motions approach the cycle from other states; and, where a
/// flow has further modes that hardly decay (several bodies, several states), a large swing of each of them.
LargeStarts large_starts(const SlidingFlow& flow, const SlowMode& mode);
LargeStarts large_starts(const ChainFlow& flow, const SlowMode& mode);
/// Only the start from near rest: the other modes of a motion with a past have no states to be swung in.
LargeStarts large_starts(const DelayedFlow& flow, const SlowMode& mode);

}  // namespace stickslip
