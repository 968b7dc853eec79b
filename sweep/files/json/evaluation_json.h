// The answer for one joint as `stickslip evaluate --json` prints it: documented, stable names.
#pragma once
#include "sweep/study/evaluation.h"

#include <nlohmann/json.hpp>

#include <string>

namespace stickslip {

/// `servo`: what a servo's name in the joint file stands for; empty without one.
nlohmann::ordered_json evaluation_json(const JointEvaluation& evaluation, const std::string& servo);

}  // namespace stickslip
