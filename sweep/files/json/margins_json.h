// The margins of a joint as `stickslip margins --json` prints them.
#pragma once
#include "sweep/study/margins_answer.h"

#include <nlohmann/json.hpp>

namespace stickslip {

nlohmann::ordered_json margins_json(const MarginsAnswer& answer);

}  // namespace stickslip
