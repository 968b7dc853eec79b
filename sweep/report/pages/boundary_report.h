// Located boundaries as a page.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/results/report.h"
#include "sweep/study/boundary_answer.h"
#include "sweep/study/maps.h"
#include "sweep/words/boundary_text.h"

#include <string>
#include <vector>

namespace stickslip {

/// What the design does and how far it is from each boundary first; curves of one pair of axes on one map, rays in a
/// table.
Report boundary_report(const BoundaryAnswer& answer, const ParallelFor& parallel);

/// The map of linear regions over two axes that located curves are drawn on.
StabilityMap map_under(const Joint& design, Axis x, Axis y, const ParallelFor& parallel);

}  // namespace stickslip
