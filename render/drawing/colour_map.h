// Published colour maps, entry by entry.
#pragma once
#include "render/drawing/colour.h"
#include "render/drawing/encode.h"

#include <array>
#include <cstdint>

namespace stickslip::drawing {

/// 256 sRGB entries, 0xrrggbb.
using ColourTable = std::array<std::uint32_t, 256>;

/// Diverging, light in the middle, readable with colour-vision deficiency. F. Crameri, Scientific colour maps 7.0.1,
/// doi:10.5281/zenodo.5501399 (MIT licence); F. Crameri, G. E. Shephard, P. J. Heron, Nat. Commun. 11, 5444 (2020).
extern const ColourTable vik_table;

/// Sequential, even in lightness. S. van der Walt and N. Smith for matplotlib 2.0 (CC0), rounded to 8 bits.
extern const ColourTable viridis_table;

/// The colour at `position` in [0, 1], interpolated between entries; outside, the nearest end.
Colour sample(const ColourTable& table, double position);

/// The table as one column of pixels, its last entry on top.
Raster bar_colours(const ColourTable& table);

}  // namespace stickslip::drawing
