// Everything that one question about boundaries was answered with.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/boundary.h"
#include "analysis/results/set_point.h"
#include "sweep/study/hunting_field.h"
#include "sweep/study/idle_axes.h"
#include "sweep/study/left_out_loop.h"
#include "sweep/study/meetings.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// Curves that share their axes, and what the joint does under them.
struct BoundaryChart {
    std::vector<FollowedBoundary> curves;
    std::optional<StabilityMap> sliding = {};  ///< where not all of them are of hunting
    std::optional<HuntingField> at_rest = {};  ///< where one of them is
};

struct BoundaryAnswer {
    std::string title, command;
    Joint design;
    LoopUse loop;                              ///< of the linear verdicts
    std::vector<IdleAxis> idle = {};           ///< axes of linear boundaries that no linear verdict depends on
    std::optional<LeftOutLoop> left_out = {};  ///< with --ideal-loop
    Region region = Region::undecided;         ///< of the design; bistable where a ray or a chart says so
    std::vector<LocatedRay> rays;
    std::vector<FollowedBoundary> curves;
    std::vector<Meeting> meetings = {};      ///< of the boundaries with the lines through the design
    std::vector<BoundaryChart> charts = {};  ///< of the curves; none where a stop was requested before
    std::string outcome_means;               ///< "position of 0.0001 m", mark-up, where outcomes were requested
    std::optional<SetPoint> set_point = {};  ///< of the design, where boundaries of hunting were requested
};

}  // namespace stickslip
