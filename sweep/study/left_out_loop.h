// The loop that an ideal one stands in place of, where the joint has another.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/point.h"

#include <optional>
#include <string>

namespace stickslip {

/// What is told of it.
struct LeftOut {
    LoopUse loop;
    double growth = missing;  ///< max Re s of the joint as described; NaN where it has none
};

struct LeftOutLoop : LeftOut {
    Joint joint;  ///< as described; of a cascade with its sum of gains
};

/// Nothing where the ideal loop is the joint's own.
std::optional<LeftOutLoop> left_out_loop(const Joint& described);

/// Whether a joint without its loop still has that number: an axis over another one would bring the loop back.
bool kept_by_ideal(const Joint& ideal, const std::string& path);

}  // namespace stickslip
