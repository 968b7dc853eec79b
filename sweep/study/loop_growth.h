// Why a simulated record ends early or runs away: whether the loop that followed the reference is itself unstable.
#pragma once
#include "analysis/simulation/sampled/loop_record.h"

#include <optional>

namespace stickslip {

/// A loop that does not keep to its reference.
struct UnstableLoop {
    bool diverges = false;      ///< the motion runs away from the reference
    double farthest = missing;  ///< from the reference, as read [m | rad]
    double velocity = missing;  ///< of the sliding whose growth was judged: the fastest of the reference, else V_0
    double growth = missing;    ///< of small disturbances of it [1/s]; NaN without a verdict
};

/// Nothing where the record keeps to its reference to the end, and where it ends early although its loop is stable.
std::optional<UnstableLoop> unstable_loop(const Joint& joint, const LoopRecord& record);

}  // namespace stickslip
