// The start of a motion at a few nodes of a chart, so that a place can be seen to slide or to stick.
#pragma once
#include "sweep/study/maps.h"

namespace stickslip {

/// Simulates a coarse lattice of nodes in parallel: the motion that `stickslip simulate` gives there, thinned for a
/// picture. Nodes without equations of motion are left out.
std::vector<MapMotion> map_motions(const Joint& joint, const Slice& slice);

/// At most `points` of a motion, the extremes of every stretch among them.
MapMotion thinned(const std::vector<double>& time, const std::vector<double>& velocity, std::size_t points);

}  // namespace stickslip
