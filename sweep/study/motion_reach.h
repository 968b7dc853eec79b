// What a machine must bear to follow a motion.
#pragma once
#include <vector>

namespace stickslip {

struct MotionReach {
    double low = 0, high = 0;         ///< positions
    double fastest = 0, hardest = 0;  ///< greatest speed and acceleration between rows
    double duration = 0;              ///< s
};

/// Of a motion with a row or more.
MotionReach reach_of(const std::vector<double>& time, const std::vector<double>& position);

}  // namespace stickslip
