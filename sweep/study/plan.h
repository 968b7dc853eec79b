// The question of `stickslip plan`: what can this motion show of this joint, and which motion shows more?
#pragma once
#include "analysis/diagnosis/plan/power.h"
#include "analysis/diagnosis/plan/safe_motion.h"

#include <optional>

namespace stickslip {

struct PlanAnswer {
    gap::Power power;
    std::optional<gap::SafeMotion> better;  ///< no farther, faster or harder, and tells more apart
    gap::Power of_better;
};

/// `time` and `position`: the reference. It is put on the joint's period, straight between its rows. `look_further`:
/// also try the cheap motions of safe_motion.h. Throws std::invalid_argument as gap::power_of does.
PlanAnswer plan(const Joint& joint, const std::vector<double>& time, const std::vector<double>& position,
                bool look_further, const ParallelFor& parallel);

}  // namespace stickslip
