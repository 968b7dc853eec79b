// Where a nonlinear sweep contradicts its own linear chart: the linear theory finds smooth sliding while a larger
// disturbance ends in a limit cycle, and how far that reaches.
#pragma once
#include "analysis/results/point.h"
#include "sweep/study/maps.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace stickslip {

struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
    void add(double value) { low = std::min(low, value), high = std::max(high, value); }
};

/// The fold that lies farthest beyond its critical gain, where the chart has k_p.
struct FoldReach {
    double ratio = missing, k_p = missing, k_cr = missing, at = missing;  ///< `at`: on the other axis
};

struct LargeDisturbances {
    double bistable = 0;            ///< share of the chart, axes as drawn
    double of_linearly_stable = 0;  ///< share of what the linear theory calls stable
    Extent x, y;                    ///< of the bistable points
    std::vector<Curve> folds;       ///< of limit cycles, located
    FoldReach reach;
    bool without_boundary = false;  ///< some bistable points lie where no k_p of the chart is linearly unstable
};

inline constexpr const char* gain_path = "control.k_p";

/// `design` gives the parameters that the slice does not vary. Where the slice holds bistable points, the folds are
/// followed over it, which takes a few hundred motions.
LargeDisturbances large_disturbances(const Joint& design, const Slice& slice);

}  // namespace stickslip
