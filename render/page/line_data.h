// The numbers behind a chart of lines.
#pragma once
#include "render/render.h"

#include <string>

namespace stickslip::drawing {

/// For the page's script.
std::string chart_data(const DetailedChart& chart, const RenderedFigure& rendered);

/// Whether a picture is a time series too long to be read as it is printed.
bool zoomable(const Picture& picture);

}  // namespace stickslip::drawing
