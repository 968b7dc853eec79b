// The gains that would be right for the joint of a diagnosis, and how both joints move, in words.
#pragma once
#include "sweep/study/corrected_gains.h"

#include <string>

namespace stickslip {

/// Which gains would be right and under which assumptions, or why none are known. `with` names the corrected joint:
/// "with stribeck".
std::string right_gains_text(const CorrectedGains& gains, Units units, const std::string& with);

/// "between 0 m/s and 3 mm/s, at rest for 40 % of it".
std::string settled_text(const SettledMotion& motion, Units units);

}  // namespace stickslip
