// Stability over both gains of one joint with a real loop, beside what the paper's loop allows.
#pragma once
#include "sweep/study/map_answer.h"

#include <optional>

namespace stickslip {

struct GainChart {
    Slice slice;
    MapAnswer answer;  ///< boundaries and the design; no motions, folds or reductions
};

/// Over k_p and k_v around the joint's own gains, wide enough for the windows of both loops. Nothing of an ideal loop,
/// whose boundaries the sections beside it show, without steady sliding, and where k_p and k_v are not turned alone.
std::optional<GainChart> gain_chart(const Joint& joint);

}  // namespace stickslip
