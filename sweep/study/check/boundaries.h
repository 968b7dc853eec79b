// The boundary locations that a regression watches: rays through the charts and the design point of a spec.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/results/boundary.h"
#include "sweep/study/spec.h"

#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// One boundary crossing of one ray, as it is stored in a baseline.
struct WatchedBoundary {
    std::string theory;  ///< "velocity_only" | "state_variable" | "v_min" | "fold" | "outcome"
    std::string axis;    ///< path that moves along the ray
    std::string unit;
    std::vector<std::pair<std::string, double>> at;  ///< where the ray stands: path, value
    int number = 0;                                  ///< which crossing of the ray, counted from its low end
    BoundaryPoint point;
    double tolerance = 0;  ///< relative, allowed between stored and recomputed value

    /// Equal for the same crossing of the same ray.
    std::string name() const;
};

/// Locates boundaries on nine rays along x through each chart of the report, and along each axis through the design
/// point: both linear theories; V_min where control.V0 is an axis; folds where the spec asks for nonlinear outcomes,
/// and outcomes where it states the size of the disturbance. Tolerance of each: what the spec states, else the
/// precision promised for its kind (1e-9 linear, 1e-6 fold, 1e-4 outcome), but never less than four times its own
/// bracket.
std::vector<WatchedBoundary> watched_boundaries(const Spec& spec, const ParallelFor& parallel);

/// How one boundary of a baseline fares against the recomputed ones.
struct Deviation {
    enum class Kind {
        within,   ///< the same, to its tolerance
        refined,  ///< within, and located at least ten times more finely than in the baseline: no regression
        moved,    ///< beyond its tolerance
        changed,  ///< in another unit, or the stable side is the other one: the numbers cannot be compared
        coarser,  ///< in place, but the bracket has grown beyond the tolerance: the method got worse
        vanished,
        appeared
    };
    Kind kind = Kind::within;
    WatchedBoundary stored, now;  ///< `now` is empty for vanished, `stored` for appeared
    double relative = 0;          ///< |now − stored| / |stored|

    bool passes() const { return kind == Kind::within || kind == Kind::refined; }
};

std::vector<Deviation> compare(const std::vector<WatchedBoundary>& stored, const std::vector<WatchedBoundary>& now);

}  // namespace stickslip
