// What a stability map and its small multiples share: colours of the field, textures of the regions, boundaries,
// legend.
#pragma once
#include "analysis/results/stability_map.h"
#include "render/axes/frame.h"
#include "render/pictures/placement.h"
#include "render/pictures/region_raster.h"
#include "render/pictures/regions.h"
#include "render/pictures/signed_field.h"

#include <memory>
#include <vector>

namespace stickslip::drawing {

/// Verdicts over two axes, with the boundaries located between their nodes.
struct StabilityBody {
    const Axis &x, &y;
    const std::vector<double>& abscissa;
    const std::vector<Region>& region;
    const std::vector<Curve>& curves;
};

/// What was drawn, for the labels that come on top.
struct DrawnBody {
    std::shared_ptr<const RegionRaster> regions;
    Obstacles obstacles;  ///< the boundaries

    Covers covers(Region region) const;
};

/// Field, textures and boundaries, in this order. Throws std::invalid_argument, naming `title`, on arrays that do not
/// match.
DrawnBody draw_body(Canvas& canvas, const Frame& frame, const StabilityBody& body, const FieldScale& scale,
                    const std::string& title);

/// The boundaries and regions that occur, and the design's mark.
std::vector<LegendEntry> body_legend(Canvas& canvas, const std::vector<StabilityBody>& bodies, bool has_design,
                                     UnsmoothEnd unsmooth = UnsmoothEnd::stick_slip);

/// The bar of the field's colours, right of `plot`.
void draw_body_bar(Canvas& canvas, const Rectangle& plot, const FieldScale& scale);

}  // namespace stickslip::drawing
