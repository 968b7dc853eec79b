// What a joint does over the axes of located curves, and on which side of its boundaries the design lies.
#pragma once
#include "analysis/base/parallel_for.h"
#include "sweep/study/boundary_answer.h"

namespace stickslip {

/// The regions of linear theory over two axes, with the design; its title is left to the page.
StabilityMap stability_under(const Joint& design, Axis x, Axis y, const ParallelFor& parallel);

/// One chart for each run of curves that share their axes: sliding under all of them, and what a set point does under
/// those of hunting. What lies between linear and nonlinear curves is marked bistable.
std::vector<BoundaryChart> boundary_charts(const Joint& design, const std::vector<FollowedBoundary>& curves,
                                           const ParallelFor& parallel);

/// Whether the design is stable and lies on that side of a fold or an outcome boundary on a ray where cycles are.
bool beyond_ray(const Joint& design, const LocatedRay& ray);

}  // namespace stickslip
