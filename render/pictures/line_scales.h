// The axes of a line chart as drawn: the picture and the page's reader over it share them.
#pragma once
#include "analysis/results/detailed_chart.h"
#include "render/axes/scale.h"

namespace stickslip::drawing {

struct LineScales {
    Scale x, y;
    Scale below = {};  ///< y of the panel below, where there is one
};

/// A value that a log axis of y cannot show, zero or close to it, belongs on the lower edge. Throws
/// std::invalid_argument where no line has a value that its axis can show.
LineScales scales_of(const DetailedChart& chart);
LineScales scales_of(const LineChart& chart);

}  // namespace stickslip::drawing
