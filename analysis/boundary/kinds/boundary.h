// Boundaries of a joint, of every kind: along one axis, and over two.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/boundary/trace/follow.h"
#include "analysis/joint/joint.h"
#include "analysis/results/disturbance.h"

#include <string>

namespace stickslip {

/// Which boundary is searched for, and how closely.
struct BoundaryRequest {
    BoundaryKind kind = BoundaryKind::state_variable;  ///< which boundary is looked for
    Disturbance disturbance;                           ///< of kind `outcome`
    double precision = not_set;                        ///< relative bracket width; not set: default_precision
    int scan = 0;                ///< intervals of a ray that are looked at first; 0: default_scan, more on a long axis
    FollowingOptions following;  ///< of curves over two axes
    ParallelFor parallel;        ///< empty: one after the other

    /// What is wrong with them; empty if nothing.
    std::string problem() const;
};

/// 1e-10 for the linear theories, 1e-6 for folds and hunting, 1e-4 for outcomes; 3e-4 is that of folds found by
/// simulation (all but those of one body with memory in the ideal loop).
double default_precision(BoundaryKind kind);
/// 200 intervals for the linear theories, 40 where each point is a motion; a linear theory is evaluated at 8 a decade
/// at least.
int default_scan(BoundaryKind kind);

/// Every boundary of a kind between the ends of an axis, and what the search does not exclude. v_min: along control.V0,
/// the velocity from which on every faster one slides, nothing else. Throws std::invalid_argument for a path that the
/// joint lacks and for a request with a problem().
LocatedRay locate_boundaries(const Joint& joint, const Axis& axis, const BoundaryRequest& request);

/// The same over a chart, followed. v_min: the y axis has to be control.V0. Throws as locate_boundaries, and for v_min
/// over another y axis.
FollowedBoundary follow_boundaries(const Joint& joint, const Axis& x, const Axis& y, const BoundaryRequest& request);

/// Whether the joint hunts at a set point, as a side.
double hunting_side(const Joint& joint);

/// Whether closed orbits can be solved for all over the axes: one body with memory in the ideal loop. All other folds
/// lie where simulation distinguishes a joint with a cycle from one without.
bool has_smooth_orbits(const Joint& joint, const std::vector<Axis>& axes);

/// The side of a joint: negative where stable (no limit cycle; the disturbance dies out; no hunting), positive where
/// not, NaN where it cannot be decided. Continuous for the linear kinds.
double side_of(const Joint& joint, const BoundaryRequest& request);

}  // namespace stickslip
