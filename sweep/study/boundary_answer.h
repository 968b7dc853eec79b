// Everything that one question about boundaries was answered with.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/results/set_point.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

struct BoundaryAnswer {
    std::string title, command;
    Joint design;
    std::vector<LocatedRay> rays;
    std::vector<FollowedBoundary> curves;
    std::string outcome_means;               ///< "position of 0.0001 m", mark-up, where outcomes were asked for
    std::optional<SetPoint> set_point = {};  ///< of the design, where boundaries of hunting were asked for
};

}  // namespace stickslip
