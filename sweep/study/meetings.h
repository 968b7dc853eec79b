// Where located boundaries meet the lines through a design along one of its numbers, and what lies behind them.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/set_point.h"

#include <optional>
#include <vector>

namespace stickslip {

struct Meeting {
    BoundaryKind kind = BoundaryKind::state_variable;
    Axis axis;                            ///< the number that moves, all others held; values: only the ends
    double own = 0;                       ///< the design's
    double at = 0;                        ///< where the boundary is met first
    bool on_chart = false;                ///< read from a followed curve between its points, not located along the line
    std::optional<SetPoint> beyond = {};  ///< of a boundary of hunting: what the joint does behind it, if that is clear
};

/// One for each ray that holds a boundary, then for each curve and axis of it on which it lies before or behind the
/// design.
std::vector<Meeting> meetings_of(const Joint& design, const std::vector<LocatedRay>& rays,
                                 const std::vector<FollowedBoundary>& curves);

}  // namespace stickslip
