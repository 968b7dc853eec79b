// The pieces of a boundary that have been followed so far, as polygons in scaled coordinates. Internal to
// analysis/boundary.
#pragma once
#include "analysis/boundary/trace/chart.h"

#include <algorithm>
#include <vector>

namespace stickslip {

class FollowedPaths {
  public:
    void add(std::vector<UnitPoint> path) { paths_.push_back(std::move(path)); }

    /// How often the pieces cross the straight line from a to b.
    int crossings(UnitPoint a, UnitPoint b) const
    {
        int count = 0;
        const UnitPoint edge = b - a;
        for (const auto& path : paths_)
            for (std::size_t k = 1; k < path.size(); ++k) {
                const UnitPoint way = path[k] - path[k - 1];
                const bool apart = (way.cross(a - path[k - 1]) < 0) != (way.cross(b - path[k - 1]) < 0);
                count += apart && (edge.cross(path[k - 1] - a) < 0) != (edge.cross(path[k] - a) < 0);
            }
        return count;
    }

    /// Whether a piece passes p at less than `near`.
    bool pass(UnitPoint p, double near) const
    {
        for (const auto& path : paths_)
            for (std::size_t k = 0; k < path.size(); ++k) {
                const UnitPoint a = path[k], way = path[std::min(k + 1, path.size() - 1)] - a;
                const double length2 = way.dot(way);
                const double share = length2 > 0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0;
                if ((p - a - share * way).length() < near) return true;
            }
        return false;
    }

  private:
    std::vector<std::vector<UnitPoint>> paths_;
};

}  // namespace stickslip
