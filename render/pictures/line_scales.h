// The axes of a line chart as drawn: the picture and the page's reader over it share them.
#pragma once
#include "analysis/results/stability_panels.h"
#include "render/axes/scale.h"

namespace stickslip::drawing {

struct LineScales {
    Scale x, y;
};

/// A value that a log axis of y cannot show, zero or close to it, belongs on the lower edge. Throws
/// std::invalid_argument where no line has a value that its axis can show.
LineScales scales_of(const LineChart& chart);

}  // namespace stickslip::drawing
