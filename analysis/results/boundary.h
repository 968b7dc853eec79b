// Where a stability boundary lies: located points with their brackets, and margins of a design.
#pragma once
#include "analysis/results/stability_map.h"

#include <string>
#include <vector>

namespace stickslip {

/// One located point of a boundary along one parameter. The true crossing lies within [low, high].
struct BoundaryPoint {
    double value = 0, low = 0, high = 0;
    int direction = 0;       ///< +1: turns unstable as the parameter rises; −1: turns stable
    bool converged = false;  ///< false: the bracket is wider than asked for
    int evaluations = 0;

    double precision() const { return value != 0 ? (high - low) / (value < 0 ? -value : value) : high - low; }
};

/// How far one parameter of a design may move alone before the state-variable boundary is met.
struct Margin {
    Axis axis;                 ///< values empty
    double value = 0;          ///< the design's
    bool found = false;        ///< whether the searched range holds a boundary at all
    double boundary = 0;       ///< nearest one
    double low = 0, high = 0;  ///< the searched range
};

}  // namespace stickslip
