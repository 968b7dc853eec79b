// On which side of an outcome boundary joints lie. Internal to analysis/boundary.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/joint/joint.h"

#include <vector>

namespace stickslip {

/// For each joint −1 where the disturbance ends in steady sliding, +1 where it does not, NaN where that is not known.
std::vector<double> outcome_sides(const std::vector<Joint>& joints, const Disturbance& disturbance,
                                  const ParallelFor& parallel);

/// The same for one joint, in the calling thread.
double outcome_side(const Joint& joint, const Disturbance& disturbance);

}  // namespace stickslip
