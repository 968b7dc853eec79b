// The boundary of the full joint and of its reductions in one chart of a sweep.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/reduced_map.h"

namespace stickslip {

Figure reduction_map(const Slice& slice, const ReducedMap& map, Units units);

}  // namespace stickslip
