// Following a boundary over a chart, through turns, corners, cusps and islands, with a coarse grid that guards against
// missed pieces. Knows nothing of joints: the boundary is where a measure of two numbers changes its sign.
#pragma once
#include "analysis/results/boundary.h"

#include <functional>
#include <string>
#include <vector>

namespace stickslip {

/// A measure whose sign distinguishes the two sides of a boundary; NaN where it cannot say.
struct Sides {
    std::function<double(double x, double y)> at;
    bool continuous = true;   ///< its size goes to zero at the boundary; otherwise its sign is all that counts
    double precision = 1e-9;  ///< relative width of each bracket
    /// Many at once, for the guard (may run side by side); empty: one after the other.
    std::function<void(const std::vector<double>& x, const std::vector<double>& y, std::vector<double>& values)> many;
};

struct FollowingOptions {
    int guard = 0;            ///< cells of the guarding grid along each axis; 0: default_guard
    double longest_step = 0;  ///< as a share of an axis; 0: default_step
    double shortest_step = 1e-4;
    double turn = 0.3;  ///< rad between neighbouring steps before the step is shortened
    int point_limit = 4000;

    /// What is wrong with them; empty if nothing.
    std::string problem() const;
};

/// As many points as a fine grid has rows where the measure is continuous, fewer where each one is searched by sides.
inline double default_step(bool continuous)
{
    return continuous ? 1.0 / 80 : 1.0 / 48;
}

/// Cells of the guarding grid along each axis; fewer where each node is a motion.
inline int default_guard(bool continuous)
{
    return continuous ? 16 : 8;
}

/// Every piece that the guard or its climbs reveal, followed to its ends. Each point is bracketed along the axis which
/// the curve crosses more steeply. `kind` of the result is left as it is.
FollowedBoundary follow_boundary(const Sides& sides, const Axis& x, const Axis& y, const FollowingOptions& options);

}  // namespace stickslip
