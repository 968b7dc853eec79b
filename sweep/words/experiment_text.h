// The next experiment in words.
#pragma once
#include "analysis/results/diagnosis.h"

#include <string_view>

namespace stickslip {

/// "a sine of small amplitude with many reversals"; empty where no motion was found.
std::string_view motion_text(TestMotion motion);

}  // namespace stickslip
