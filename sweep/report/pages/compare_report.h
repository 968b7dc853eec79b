// What changed from one sweep to another: verdict, numbers of the design, boundaries, regions, with maps of the
// difference.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/sweep_summary.h"

#include <string>

namespace stickslip {

/// One of the two sweeps. `name` is what the reader calls it: its directory.
struct ComparedRun {
    std::string name;
    Spec spec;
    SweepSummary summary;
};

/// Whether both sweeps have the same axes with the same values, so that they can be compared point by point.
bool same_grid(const ComparedRun& before, const ComparedRun& after);

/// The page. Where the grids differ it compares the designs only, and says so.
Report compare_report(const ComparedRun& before, const ComparedRun& after);

}  // namespace stickslip
