// The marks by which the lines of a chart are distinguished without colour. A mark is a datum: it stands on a sample.
#pragma once
#include "render/drawing/canvas.h"

#include <cstddef>

namespace stickslip::drawing {

/// One of four shapes by the line's place in the chart.
void draw_mark(Canvas& canvas, Point at, std::size_t index, Colour colour);

/// Which samples within the window carry a mark: all of few, otherwise some that lie well apart along the line, those
/// of neighbouring lines at other places.
std::vector<Point> marked_samples(const Polyline& samples, const Rectangle& window, std::size_t index);

}  // namespace stickslip::drawing
