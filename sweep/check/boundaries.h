// The boundary locations that a regression watches: rays through the charts and the design point of a spec.
#pragma once
#include "analysis/results/boundary.h"
#include "sweep/spec.h"

#include <string>
#include <utility>
#include <vector>

namespace stickslip {

/// One boundary crossing of one ray, as it is stored in a baseline.
struct WatchedBoundary {
    std::string theory;  ///< "velocity_only" | "state_variable"
    std::string axis;    ///< path that moves along the ray
    std::string unit;
    std::vector<std::pair<std::string, double>> at;  ///< where the ray stands: path, value
    int number = 0;                                  ///< which crossing of the ray, counted from its low end
    BoundaryPoint point;
    double tolerance = 0;  ///< relative, allowed between stored and recomputed value

    /// Equal for the same crossing of the same ray.
    std::string name() const;
};

/// Locates both theories' boundaries on nine rays along x through each chart of the report, and along each axis through
/// the design point. Tolerance of each: the spec's, but never less than what the point's own bracket allows.
std::vector<WatchedBoundary> watched_boundaries(const Spec& spec);

/// How one boundary of a baseline fares against the recomputed ones.
struct Deviation {
    enum class Kind { within, moved, vanished, appeared };
    Kind kind = Kind::within;
    WatchedBoundary stored, now;  ///< `now` is empty for vanished, `stored` for appeared
    double relative = 0;          ///< |now − stored| / |stored|
};

std::vector<Deviation> compare(const std::vector<WatchedBoundary>& stored, const std::vector<WatchedBoundary>& now);

}  // namespace stickslip
