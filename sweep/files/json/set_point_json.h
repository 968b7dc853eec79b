// The answer at a set point as JSON.
#pragma once
#include "analysis/results/set_point.h"

#include <nlohmann/json.hpp>

namespace stickslip {

/// hunting (null: undecided), amplitude, slip_time, stick_time, period, multiplier, and why.
nlohmann::ordered_json set_point_json(const SetPoint& answer);

}  // namespace stickslip
