// Which joints have limit cycles beside or instead of stable sliding, found by large disturbances. Internal to
// analysis/boundary.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/joint/joint.h"

#include <vector>

namespace stickslip {

/// What each joint does: −1 no cycle reached, 0 a cycle beside stable sliding, +1 sliding is unstable, NaN unknown.
std::vector<double> coexistence(const std::vector<Joint>& joints, const ParallelFor& parallel);

/// The same as sides of the fold boundary: −1 no cycle reached, +1 a cycle, NaN unknown.
std::vector<double> cycle_sides(const std::vector<Joint>& joints, const ParallelFor& parallel);

}  // namespace stickslip
