// The signed field under a stability map: linear near zero, logarithmic far from it, blue where motions decay.
#pragma once
#include "render/axes/frame.h"
#include "render/drawing/colour_map.h"
#include "render/pictures/grid.h"

#include <functional>
#include <vector>

namespace stickslip::drawing {

/// asinh(value / knee), scaled so that ±limit lie at 0 and 1 and zero at one half.
struct FieldScale {
    double knee = 1, limit = 1;

    double at(double value) const;
    double value(double position) const;
};

/// The limit is the largest size in the field; the knee a power of ten that a fifth of the field stays below, so that
/// the neighbourhood of the boundary keeps its contrast.
FieldScale field_scale(const std::vector<double>& field);

/// Labelled marks at 0 and at ±1, ±2, ±5 times powers of ten as far as `height` pixels have room for them.
std::vector<ColourBar::Mark> field_marks(const FieldScale& scale, double height);

/// The field as pixels; nodes without a value stay grey.
Raster field_raster(const Grid& grid, const std::vector<double>& field, const FieldScale& scale, int width, int height);

/// Whether a pixel of a raster has a value.
using Shown = std::function<bool(int column, int row)>;

/// The same for positions in [0, 1] of a colour table; NaN is grey. Values end half way between the nodes with one and
/// those without, or where `shown` says: there the nodes that have one speak for the pixel.
Raster table_raster(const Grid& grid, const std::vector<double>& positions, const ColourTable& table, int width,
                    int height, const Shown& shown = {});

constexpr Colour no_value = from_hex(0xb8bcc2);

}  // namespace stickslip::drawing
