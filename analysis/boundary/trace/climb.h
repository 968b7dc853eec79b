// Between the nodes of a grid: does a measure reach zero where all nodes around say that it does not?
#pragma once
#include "analysis/boundary/trace/chart.h"

#include <functional>

namespace stickslip {

struct Climb {
    UnitPoint p;
    double value = 0;
};

/// The least value of `measure` within `reach` of `start` (and the unit square) that a local search without
/// derivatives finds; stops as soon as it is negative. NLopt's SBPLX, which is deterministic.
Climb climb_to_zero(const std::function<double(UnitPoint)>& measure, UnitPoint start, double reach);

/// The same along a line within [low, high].
double climb_to_zero(const std::function<double(double)>& measure, double start, double low, double high);

}  // namespace stickslip
