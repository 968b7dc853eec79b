// What changed from one sweep to another: verdict, numbers of the design, boundaries, regions, with maps of the
// difference.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/compare/compare_sweeps.h"

namespace stickslip {

/// The page. Where the grids differ it compares the designs only, and says so.
Report compare_report(const SweepComparison& comparison);

}  // namespace stickslip
