// The numbers behind a figure, as they travel inside the page: JSON with base64 blocks, little-endian.
#pragma once
#include "render/render.h"

#include <string>

namespace stickslip::drawing {

/// For page.js. A map's field is Float32, its regions bytes, axes and lines Float64.
std::string figure_data(const Figure& figure, const RenderedFigure& rendered);

}  // namespace stickslip::drawing
