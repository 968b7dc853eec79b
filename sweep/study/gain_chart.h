// Stability over both gains of one joint.
#pragma once
#include "analysis/base/crossing.h"
#include "sweep/study/map_answer.h"

#include <optional>

namespace stickslip {

struct GainChart {
    Slice slice;
    MapAnswer answer;  ///< boundaries and the design; no motions, folds or reductions
};

/// Over these ranges of k_p and k_v, both above zero, on logarithmic axes. Nothing of a joint without steady sliding or
/// without both gains to turn.
std::optional<GainChart> gain_chart_over(const Joint& joint, const Interval& k_p, const Interval& k_v);

/// Beside what the paper's loop allows: over k_p and k_v around the joint's own gains, wide enough for the windows of
/// both loops. Nothing of an ideal loop, whose boundaries the sections beside it show, without steady sliding, and
/// where k_p and k_v are not turned alone.
std::optional<GainChart> gain_chart(const Joint& joint);

}  // namespace stickslip
