// The nonlinear verdict as `stickslip evaluate --json` prints it: documented, stable names.
#pragma once
#include "analysis/results/nonlinear_verdict.h"

#include <nlohmann/json.hpp>

#include <string>

namespace stickslip {

/// {"outcome", "region", "disturbance": {"kind", "size"}, "growth_rate", "amplitude", …}; what does not exist is null.
nlohmann::ordered_json nonlinear_json(const NonlinearVerdict& verdict);

/// stable | bistable | stick-slip | undecided
std::string region_name(NonlinearRegion region);

}  // namespace stickslip
