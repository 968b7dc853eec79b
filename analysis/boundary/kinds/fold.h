// Folds of limit cycles: where a stable and an unstable cycle merge and beyond which neither exists.
#pragma once
#include "analysis/boundary/kinds/boundary.h"

namespace stickslip {

/// Folds along an axis. Branches of cycles are followed from subcritical crossings of the linear boundary, and from
/// cycles that a start from near rest reaches at a node of the scan while none is reached at its neighbour.
LocatedRay locate_folds(const Joint& joint, const Axis& axis, const BoundaryRequest& request);

/// The same over a chart, each fold then followed to its ends.
FollowedBoundary follow_folds(const Joint& joint, const Axis& x, const Axis& y, const BoundaryRequest& request);

}  // namespace stickslip
