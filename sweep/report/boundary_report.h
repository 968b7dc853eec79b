// Located boundaries as a page.
#pragma once
#include "analysis/boundary/boundary.h"
#include "analysis/results/report.h"
#include "sweep/report/boundary_text.h"
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
    std::string outcome_means;  ///< "position of 0.0001 m", mark-up, where outcomes were asked for
};

/// What the design does and how far it is from each boundary first; curves of one pair of axes on one map, rays in a
/// table.
Report boundary_report(const BoundaryAnswer& answer, const ParallelFor& parallel);

/// The map of linear regions over two axes that located curves are drawn on.
StabilityMap map_under(const Joint& design, Axis x, Axis y, const ParallelFor& parallel);

}  // namespace stickslip
