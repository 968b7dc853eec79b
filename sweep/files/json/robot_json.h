// robot.json: the joints of a robot and what each diagnosis found, under documented, stable names.
#pragma once
#include "sweep/study/robot_answer.h"

#include <nlohmann/json.hpp>

namespace stickslip {

/// `pages`: whether each joint has its report.html.
nlohmann::ordered_json robot_json(const RobotAnswer& robot, bool pages);

}  // namespace stickslip
