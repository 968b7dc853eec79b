// What is computed beside the points of a sweep for a chart over two of its axes: located boundaries, the design,
// motions at a few nodes, what larger disturbances do, and how well reductions do.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/study/large_disturbances.h"
#include "sweep/study/maps.h"
#include "sweep/study/reduced_map.h"

#include <optional>
#include <vector>

namespace stickslip {

struct MapAnswer {
    std::vector<Curve> curves;                     ///< boundaries of both theories, those that are met
    std::vector<std::vector<Curve>> layer_curves;  ///< the same, one set a layer of the slice
    double precision = missing;                    ///< relative width of the brackets around the curves' points
    int mesh = 0;                                  ///< lines along each axis on which they were looked for
    DesignPoint design;
    std::vector<MapMotion> motions;
    LargeDisturbances large;
    std::optional<ReducedMap> reduced;
};

MapAnswer answer_map(const Joint& design, const Slice& slice);

/// Both theories' boundaries over two axes, those that are met, and that of the paper's loop beside a real one; `mesh`
/// as in locate_over_chart.
std::vector<Curve> chart_boundaries(const Joint& joint, const Axis& x, const Axis& y, int mesh);

/// The design as a slice shows it: the slice's axes at their design values, the others as held.
DesignPoint design_point(const Joint& design, const Slice& slice);

/// k_cr over two parameters, the others as in the design, and why it is missing where it is.
struct GainSurface {
    Axis x, y;
    std::vector<double> k_cr;                   ///< row-major, x fastest; NaN where there is no single one
    double always = 0, never = 0, windows = 0;  ///< shares of the points: every gain stable, none, windows of them
};

GainSurface gain_surface(const Joint& design, const Axis& x, const Axis& y);

}  // namespace stickslip
