// How each region of a stability map looks and what it is called. Every region has a texture of its own, so that the
// map reads without colour.
#pragma once
#include "analysis/results/stability_map.h"
#include "render/drawing/canvas.h"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace stickslip::drawing {

/// The regions in the order of the legend.
constexpr Region all_regions[] = {Region::stable,   Region::memory_only, Region::velocity_only, Region::unstable,
                                  Region::bistable, Region::neutral,     Region::undecided};

/// How the motion ends where it does not slide on: stick-slip, rest for good where limits leave less effort than breaks
/// static friction, or either, depending on the point.
enum class UnsmoothEnd : std::uint8_t { stick_slip, mixed, rest };
UnsmoothEnd unsmooth_end(const StabilityMap& map);

std::string_view region_name(Region region);  ///< "memory-only": for files and scripts
std::string_view region_text(Region region, UnsmoothEnd unsmooth = UnsmoothEnd::stick_slip);  ///< for the legend

/// Where a texture goes: in pixels of the canvas.
using Covers = std::function<bool(Point)>;

/// Fills the covered part of `box` with the region's texture; the stable region has none.
void draw_texture(Canvas& canvas, Region region, const Rectangle& box, const Covers& covers);

/// Legend: one swatch and text for each region present, in columns. Returns the lower edge.
struct LegendEntry {
    std::function<void(const Rectangle&)> swatch;
    std::string text;  ///< mark-up
};
double draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, double left, double top, double width);

}  // namespace stickslip::drawing
