// Located boundaries as a page.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/boundary_answer.h"
#include "sweep/words/boundary_text.h"

#include <string>
#include <vector>

namespace stickslip {

/// What the design does and how far it is from each boundary first; curves of one pair of axes on one map, rays in a
/// table.
Report boundary_report(const BoundaryAnswer& answer);

}  // namespace stickslip
