// What is read off a motion, as JSON.
#pragma once
#include "analysis/results/quantity.h"
#include "analysis/simulation/motion_measures.h"

#include <nlohmann/json.hpp>

namespace stickslip {

/// {"format", "motion": {"travel", "overshoot", "settling_time", "final_error", "stairs", "stair_height",
/// "stair_rate"}, "units": {"time", "position", "velocity", "effort", "command"}}
nlohmann::ordered_json motion_json(const MotionMeasures& measures, Units units);

}  // namespace stickslip
