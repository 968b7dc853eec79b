// Where a surface ends: the points of its rim that a picture of it cannot show.
#pragma once
#include "analysis/results/stability_map.h"

#include <cstddef>
#include <vector>

namespace stickslip::drawing {

/// Nodes beside a hole that fall to less than a quarter of a neighbour. Towards the parameters where every gain is
/// stable the critical gain falls to zero, which a log scale has no place for; where the grid does not resolve that
/// fall, how deep the last node of a row lies says only how near to the edge it happens to be. Ascending.
std::vector<std::size_t> unresolved_rim(const CriticalGainSurface& surface);

/// The values as a picture has them: NaN at the unresolved rim. All of them where the heights need no log scale.
std::vector<double> drawn_heights(const CriticalGainSurface& surface);

/// Heights are read on a log scale: all are positive, and they span more than a factor of twenty.
bool needs_log_scale(const std::vector<double>& z);

}  // namespace stickslip::drawing
