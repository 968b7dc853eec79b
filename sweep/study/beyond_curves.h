// Where on a chart small disturbances decay and larger ones do not: between the linear boundary and located folds or
// outcome boundaries.
#pragma once
#include "analysis/results/boundary.h"
#include "analysis/results/stability_map.h"

#include <vector>

namespace stickslip {

/// Makes those linearly stable nodes of a map bistable that lie on the side of the curves where cycles are, and the
/// design of the map where it lies among them. Every node beside a curve has the side that the curve's own
/// points know; the others follow their neighbours up to the next curve. Curves of linear kinds say nothing; a kind
/// with a piece that ends within the chart for want of a verdict is left out, as its sides run into each other. The
/// map's `disagreement` is that of its new regions.
void mark_bistable(StabilityMap& map, const std::vector<FollowedBoundary>& curves);

/// The located point of a ray that lies nearest to a value, along the axis as drawn; null where there is none.
const BoundaryPoint* nearest_point(const LocatedRay& ray, double value);

/// The share of a map's area, axes as drawn, that has a region.
double share_of_area(const StabilityMap& map, Region region);

}  // namespace stickslip
