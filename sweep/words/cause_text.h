// What a diagnosis found, in the words and with the numbers of an engineer who will change the machine or its model.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/diagnosis.h"

#include <string>

namespace stickslip {

/// "14.00 ± 0.02 N·m": a number with its standard error, as many digits as the error leaves; without one, four.
std::string with_error(double value, double standard_error, const std::string& unit);

/// "Friction differs between the directions: viscous 166.9 N·s/m forwards and 240.1 N·s/m backwards." One sentence a
/// name of the cause. `after` is the joint with the cause in it; numbers stand as a joint file states them.
std::string cause_text(const Cause& cause, const Joint& before, const Joint& after);

}  // namespace stickslip
