// A design of gains as `stickslip design --json` prints it.
#pragma once
#include "sweep/study/design_answer.h"

#include <nlohmann/json.hpp>

namespace stickslip {

nlohmann::ordered_json design_json(const DesignAnswer& answer);

}  // namespace stickslip
