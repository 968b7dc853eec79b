// What a reader can change in a stability map: the layers behind its slider, and the motions at its nodes.
#pragma once
#include "analysis/results/stability_map.h"

#include <string>

namespace stickslip::drawing {

/// The third axis with all its layers: fields, regions, boundaries in chart positions, and how the field is coloured.
/// Throws std::invalid_argument when a layer does not fit the map.
std::string depth_data(const StabilityMap& map);

std::string motion_data(const StabilityMap& map);

}  // namespace stickslip::drawing
