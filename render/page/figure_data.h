// The numbers behind a figure, as they travel inside the page: JSON whose arrays are packed.
#pragma once
#include "render/render.h"

#include <cstdint>
#include <string>
#include <vector>

namespace stickslip::drawing {

/// For the page's script.
std::string figure_data(const Figure& figure, const RenderedFigure& rendered);

/// Left, top, width and height of a data area, as shares of the picture.
std::string area_data(const PlotArea& area, const RenderedFigure& rendered);

/// One axis: symbol, unit, range, values.
std::string axis_data(const Axis& axis, Units units);

std::vector<std::uint8_t> region_codes(const std::vector<Region>& regions);

}  // namespace stickslip::drawing
