// Chunks of a dense map: boxes of the plan in which few points are computed.
#pragma once
#include "analysis/simulation/attractor/nonlinear.h"
#include "sweep/engine/engine.h"

#include <vector>

namespace stickslip {

/// Rows of a chunk, cut into boxes over the last axes; each box by itself, so that a row depends on the plan alone. The
/// axes must outlive it. `bound` as in dense_points.
EvaluateChunk dense_evaluator(const NonlinearOptions& options, double bound, const std::vector<Axis>& axes);

}  // namespace stickslip
