// Folds where closed orbits cannot be solved for: between a joint that simulation finds a cycle of and one that it
// finds none of. Internal to analysis/boundary.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/trace/chart.h"

#include <optional>
#include <vector>

namespace stickslip {

/// One value of the axis and what `coexistence` says of the joint there.
struct SideAt {
    double value = 0, side = missing;
};

class FoldBySides {
  public:
    FoldBySides(const Joint& joint, const Axis& axis, const BoundaryRequest& request);

    /// At each of `count` + 1 values, evenly over the axis.
    std::vector<SideAt> scan(int count);
    /// The fold between a joint with a cycle and one without; nothing where the cycle's end turns out to slide
    /// unstably: what lies there is the linear boundary. Not converged where the bisection met a joint without a
    /// verdict.
    std::optional<BoundaryPoint> between(SideAt cycle, SideAt none);
    /// The same on the stable side of a linear boundary, where cycles may exist in a strip of which neither node of the
    /// scan knows.
    std::optional<BoundaryPoint> beside(double linear_boundary, SideAt stable);

    int evaluations() const { return evaluations_; }
    int undecided() const { return undecided_; }  ///< places beside a linear boundary without a verdict

  private:
    SideAt at(double value);

    const Joint& joint_;
    const Axis& axis_;
    const BoundaryRequest& request_;
    UnitAxis unit_;
    int evaluations_ = 0, undecided_ = 0;
};

/// The narrowest strip of cycles beside a linear boundary that `beside` sees, as a share of the way to the node.
inline constexpr double narrowest_strip = 1.0 / 64;

/// Default precision of such folds.
inline constexpr double by_sides_precision = 3e-4;

/// Folds over a chart, from the sides alone: the boundary between cycles and none, without what of it is the linear
/// boundary.
FollowedBoundary follow_folds_by_sides(const Joint& joint, const Axis& x, const Axis& y,
                                       const BoundaryRequest& request);

}  // namespace stickslip
