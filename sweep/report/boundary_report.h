// Located boundaries as a page.
#pragma once
#include "analysis/boundary/boundary.h"
#include "analysis/results/report.h"
#include "sweep/report/maps.h"

#include <string>
#include <vector>

namespace stickslip {

/// Everything that one question about boundaries was answered with.
struct BoundaryAnswer {
    std::string title, command;
    Joint design;
    std::vector<LocatedRay> rays;
    std::vector<FollowedBoundary> curves;
    Disturbance disturbance;  ///< of the outcomes
};

/// In words, what could have been missed.
std::string could_be_missed(const LocatedRay& ray);
std::string could_be_missed(const FollowedBoundary& curve);

/// What the answer of a ray is, in a sentence, with the nearest boundary outside where there is none inside.
std::string ray_text(const Joint& design, const LocatedRay& ray);

/// Curves of one pair of axes on one map, rays in a table.
Report boundary_report(const BoundaryAnswer& answer, const ParallelFor& parallel);

/// The map of linear regions over two axes that located curves are drawn on.
StabilityMap map_under(const Joint& design, Axis x, Axis y, const ParallelFor& parallel);

}  // namespace stickslip
