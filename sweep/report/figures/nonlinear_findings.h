// What a nonlinear sweep has against its own linear chart: where the linear theory promises smooth sliding while a
// larger disturbance ends in a limit cycle, and how far that reaches.
#pragma once
#include "analysis/results/point.h"
#include "sweep/study/maps.h"

#include <string>
#include <vector>

namespace stickslip {

struct NonlinearFindings {
    double bistable = 0;            ///< share of the chart, axes as drawn
    double of_linearly_stable = 0;  ///< share of what the linear theory calls stable
    double reach = missing;         ///< largest k_p at a fold per k_cr, where the chart has k_p and a k_cr
    std::vector<Curve> folds;       ///< of limit cycles, located
    std::string text;               ///< mark-up: one paragraph; empty without a bistable point
};

/// `design` gives the parameters that the slice does not vary. Where the slice holds bistable points, the folds are
/// followed over it, which takes a few hundred motions.
NonlinearFindings nonlinear_findings(const Joint& design, const Slice& slice);

}  // namespace stickslip
