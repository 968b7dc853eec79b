#include "sweep/study/motion_reach.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

MotionReach reach_of(const std::vector<double>& time, const std::vector<double>& position)
{
    MotionReach reach;
    const auto [low, high] = std::minmax_element(position.begin(), position.end());
    reach.low = *low, reach.high = *high, reach.duration = time.back() - time.front();
    for (std::size_t k = 1; k + 1 < position.size(); ++k) {
        const double before = (position[k] - position[k - 1]) / (time[k] - time[k - 1]),
                     behind = (position[k + 1] - position[k]) / (time[k + 1] - time[k]);
        reach.fastest = std::max({reach.fastest, std::abs(before), std::abs(behind)});
        reach.hardest = std::max(reach.hardest, std::abs(behind - before) / (time[k + 1] - time[k]));
    }
    return reach;
}

}  // namespace stickslip
