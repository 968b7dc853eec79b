// On which side of its linear boundary a joint lies, by its growth rate or, where that takes seconds, by a count of
// roots.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/point.h"

namespace stickslip {

/// The theory of a linear kind.
Curve::Kind theory_of(BoundaryKind kind);

/// Whether the rightmost root of the joint takes seconds, and a count of roots does not: of sampled loops around
/// delayed friction a place of the opened loop may cost as much as thousands of others.
bool is_told_by_count(const Joint& joint, BoundaryKind kind);

/// Negative where the joint is stable; its growth rate, or of what is told by a count a number of its sign.
double linear_side(const Joint& joint, BoundaryKind kind);

/// What both theories say of the joint: by its sides where that is told by a count, else by its growth rate.
Region linear_region(const Joint& joint);

}  // namespace stickslip
