// Many dated diagnoses of one joint as "stickslip-timeline/1": documented, stable names.
#pragma once
#include "sweep/study/compare/timeline.h"

#include <nlohmann/json.hpp>

namespace stickslip {

nlohmann::ordered_json timeline_json(const Timeline& timeline);

}  // namespace stickslip
