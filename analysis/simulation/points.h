// The nonlinear outcomes of many joints at once, in lanes where a law has them.
#pragma once
#include "analysis/simulation/attractor/nonlinear.h"

#include <span>
#include <vector>

namespace stickslip {

/// The nonlinear fields of many rows, points[i] for joints[i], whose linear fields stand. Equal joints and joints of
/// equal dimensionless groups are followed once. Each row depends on its joint and the options alone, not on its
/// neighbours. Single-threaded; any number of calls may run side by side.
void nonlinear_points(std::span<const Joint> joints, const NonlinearOptions& options, std::span<PointResult> points);

/// Of joints with real loops. Lanes move what they can from tick to tick side by side; the others are followed one by
/// one.
std::vector<NonlinearVerdict> real_loop_verdicts(std::span<const Joint* const> joints, const NonlinearOptions& options);

}  // namespace stickslip
