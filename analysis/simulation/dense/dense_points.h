// The nonlinear outcomes of a box of a dense map: few points are computed, the others lie on smooth functions through
// them, wherever computed points confirm it to within a bound. Where motions are not smooth in the parameters, at the
// borders between verdicts and where computing all is cheaper, every point is computed.
#pragma once
#include "analysis/results/point.h"
#include "analysis/simulation/attractor/nonlinear.h"

#include <functional>
#include <span>
#include <vector>

namespace stickslip {

/// The points of a sweep over up to three axes, the last one fastest.
struct DenseBox {
    /// One row an axis, ascending: its values, or their logarithms where they are spread by these.
    std::vector<std::vector<double>> coordinates;
    /// The joint of a point; valid until the next call.
    std::function<const Joint&(std::size_t point)> joint;
};

inline constexpr std::size_t most_dense_axes = 3;

/// Linear and nonlinear fields of all points. Rows that were not computed have the path `interpolation` and, as
/// interpolation_error, the largest difference that their cell's check points saw: at most a fifth of `bound`, which is
/// relative (of a least velocity: its logarithm's, per e-folds from V_0; of the share at rest: absolute). Verdicts are
/// those of computing every point except where an island of another verdict lies between points that are looked at,
/// 16 apart at most: wherever neighbours differ, both were computed. Each row depends on the box, the options and the
/// bound alone. Single-threaded.
void dense_points(const DenseBox& box, const NonlinearOptions& options, double bound, std::span<PointResult> points);

}  // namespace stickslip
