// The loop that an ideal one stands in place of, where the joint has another.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/point.h"

#include <optional>

namespace stickslip {

struct LeftOutLoop {
    Joint joint;  ///< as described; of a cascade with its sum of gains
    LoopUse loop;
    double growth = missing;  ///< max Re s of the joint as described; NaN where it has none
};

/// Nothing where the ideal loop is the joint's own.
std::optional<LeftOutLoop> left_out_loop(const Joint& described);

}  // namespace stickslip
