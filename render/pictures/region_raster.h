// Which region each place of a chart belongs to. Verdicts are known at nodes, boundaries between them: a place takes
// the verdict of the nearest node that no located boundary separates it from, so that textures end at the boundaries.
#pragma once
#include "analysis/results/stability_map.h"
#include "render/drawing/polyline.h"
#include "render/pictures/grid.h"

#include <vector>

namespace stickslip::drawing {

class RegionRaster {
  public:
    /// `regions` row-major over the grid; `boundaries` in pixels of the canvas, cut to `box`.
    RegionRaster(const Grid& grid, const std::vector<Region>& regions, const std::vector<Polyline>& boundaries,
                 const Rectangle& box);

    /// At a place within the box, in pixels of the canvas.
    Region at(Point p) const;

  private:
    Rectangle box_;
    std::size_t columns_, rows_;
    std::vector<Region> cells_;
};

}  // namespace stickslip::drawing
