// A change of side that values without a verdict hide. Internal to analysis/boundary/kinds.
#pragma once
#include "analysis/results/point.h"

#include <functional>

namespace stickslip {

/// Ends that lie on opposite sides, and between them the outermost values known to have no verdict; NaN: none is known.
struct SideGap {
    double low = 0, high = 0;
    double open_low = missing, open_high = missing;
    int evaluations = 0;
};

/// Closes in from both ends on where the side changes. Each step halves the wider rest: between the ends, or between an
/// end and the values without a verdict next to it. Done when the ends are `width(value)` apart or the rests are a
/// tenth of what has no verdict: simulations close to it are the longest there are, and of these none beyond `most` is
/// made.
SideGap closed_in(const std::function<double(double)>& side, SideGap gap, double side_of_low,
                  const std::function<double(double)>& width, int most = 12);

}  // namespace stickslip
