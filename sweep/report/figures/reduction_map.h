// The boundary of the full joint and of its reductions in one chart of a sweep.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "sweep/study/maps.h"

#include <optional>

namespace stickslip {

/// Over the axes of a slice, which are numbers of the full joint: each place is reduced anew, so that both sides mean
/// the same machine. Nothing for a single mass or where every reduction refuses the joint.
std::optional<Figure> reduction_map(const Joint& design, const Slice& slice);

}  // namespace stickslip
