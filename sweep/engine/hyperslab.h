// A range of row-major point numbers is not a box of the grid; this cuts it into few boxes, which NetCDF can take at
// once.
#pragma once
#include "sweep/engine/plan.h"

#include <cstddef>
#include <span>
#include <vector>

namespace stickslip {

struct Hyperslab {
    std::vector<std::size_t> start, count;  ///< one number a dimension
    std::uint64_t points() const;
};

/// Boxes that cover the range exactly, in the order of the points, so that consecutive rows fill them one after the
/// other. At most 2 n − 1 boxes for n dimensions; one empty box for no dimension.
std::vector<Hyperslab> hyperslabs(std::span<const std::size_t> shape, PointRange range);

}  // namespace stickslip
