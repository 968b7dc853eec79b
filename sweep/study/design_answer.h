// A design of gains and the joint it is for.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/design/design.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/trajectory.h"
#include "sweep/study/gain_chart.h"
#include "sweep/study/left_out_loop.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

struct DesignAnswer {
    std::string title, command;
    Joint joint;                               ///< as given
    LoopUse loop;                              ///< of the verdicts
    std::optional<LeftOutLoop> left_out = {};  ///< with --ideal-loop
    Requirements requirements;
    GainDesign design;
    GainRange range{{missing, missing}, {missing, missing}};  ///< that was searched
    std::vector<Coordinate> uncertain;                        ///< in which margins are measured
    NearestBoundary nearest;                                  ///< of the best gains, in these
    double margin_tolerance = missing;  ///< share by which these may be off at once within the margin of the best gains
    std::optional<GainChart> map;       ///< around all the choices, at the best gains; only for a page
    Trajectory motion, motion_before;   ///< after a disturbance at the commanded velocity: best gains, gains as given
};

}  // namespace stickslip
