// What a joint does at a set point, over two of its numbers.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/joint/joint.h"
#include "analysis/results/set_point.h"
#include "analysis/results/stability_map.h"

#include <vector>

namespace stickslip {

struct HuntingField {
    Axis x, y;
    std::vector<SetPoint> places;  ///< row-major: index = iy * x.values.size() + ix
    DesignPoint design;            ///< where it lies; what it does there is an answer of its own
};

/// The answer at a set point on a grid over the ranges of both axes, finer where it has a closed form.
HuntingField hunting_field(const Joint& design, Axis x, Axis y, const ParallelFor& parallel);

}  // namespace stickslip
