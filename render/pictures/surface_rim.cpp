#include "render/pictures/surface_rim.h"

#include <algorithm>
#include <cmath>

namespace stickslip::drawing {
namespace {

constexpr double log_from_ratio = 20;
constexpr double steep = 0.25;  // of a neighbour; a resolved line to zero has its last but one node at a half

}  // namespace

bool needs_log_scale(const std::vector<double>& z)
{
    double low = INFINITY, high = -INFINITY;
    for (const double v : z)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    return low > 0 && high / low > log_from_ratio;
}

std::vector<std::size_t> unresolved_rim(const CriticalGainSurface& surface)
{
    const std::size_t columns = surface.x.values.size(), rows = surface.y.values.size();
    std::vector<std::size_t> rim;
    if (!needs_log_scale(surface.z)) return rim;
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t node = j * columns + i;
            bool at_hole = false;
            double highest = 0;
            const auto look = [&](std::size_t neighbour) {
                const double v = surface.z[neighbour];
                if (std::isfinite(v))
                    highest = std::max(highest, v);
                else
                    at_hole = true;
            };
            if (i > 0) look(node - 1);
            if (i + 1 < columns) look(node + 1);
            if (j > 0) look(node - columns);
            if (j + 1 < rows) look(node + columns);
            if (at_hole && surface.z[node] < steep * highest) rim.push_back(node);
        }
    return rim;
}

std::vector<double> drawn_heights(const CriticalGainSurface& surface)
{
    std::vector<double> z = surface.z;
    for (const std::size_t node : unresolved_rim(surface)) z[node] = NAN;
    return z;
}

}  // namespace stickslip::drawing
