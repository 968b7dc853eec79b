// Two sweeps of one joint: their designs, the boundaries along each axis, and where their charts differ.
#pragma once
#include "analysis/results/boundary.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/sweep_summary.h"

#include <string>
#include <vector>

namespace stickslip {

/// One of the two sweeps. `name` is what the reader calls it: its directory.
struct ComparedRun {
    std::string name;
    Spec spec;
    SweepSummary summary;
};

/// Whether both sweeps have the same axes with the same values, so that they can be compared point by point.
bool same_grid(const ComparedRun& before, const ComparedRun& after);

/// One design of the two.
struct ComparedDesign {
    Joint joint;
    LinearVerdict verdict;
    Region region = Region::undecided;  ///< answers to large disturbances included where the run simulated them
    bool rests = false;                 ///< what does not slide on comes to rest for good, where it was simulated
    std::vector<Margin> margins;        ///< along the axes of the first sweep
};

/// Located curves over a chart, each empty where the chart has none.
struct ComparedCurves {
    Curve boundary;            ///< of the linear theory with memory
    std::vector<Curve> folds;  ///< of limit cycles
};

/// A chart whose points differ.
struct ComparedMap {
    std::size_t slice = 0;  ///< in both summaries
    ComparedCurves before, after;
    DesignPoint design;  ///< of the second sweep
};

struct SweepComparison {
    ComparedRun before, after;
    ComparedDesign was, is;
    bool comparable = false;  ///< point by point
    std::vector<ComparedMap> maps;
};

SweepComparison compare_sweeps(ComparedRun before, ComparedRun after);

}  // namespace stickslip
