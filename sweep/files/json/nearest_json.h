// The nearest boundary of a design or of margins in JSON.
#pragma once
#include "analysis/results/boundary.h"

#include <nlohmann/json_fwd.hpp>

namespace stickslip {

nlohmann::ordered_json nearest_json(const NearestBoundary& nearest);

}  // namespace stickslip
