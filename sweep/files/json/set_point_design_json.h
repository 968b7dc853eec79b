// A set point that is held without hunting, as JSON.
#pragma once
#include <nlohmann/json.hpp>

#include "analysis/results/set_point_design.h"

namespace stickslip {

nlohmann::ordered_json set_point_design_json(const SetPointDesign& design, double friction_margin);

}  // namespace stickslip
