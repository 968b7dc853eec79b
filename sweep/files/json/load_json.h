// What the theory says over a record of the normal load, as JSON.
#pragma once
#include "analysis/stability/load_study.h"

#include <nlohmann/json.hpp>

namespace stickslip {

nlohmann::ordered_json load_json(const LoadStudy& study);

}  // namespace stickslip
