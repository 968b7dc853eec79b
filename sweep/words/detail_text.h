// What is known of a motion beyond its reason, in words.
#pragma once
#include "analysis/results/detail.h"

#include <string>

namespace stickslip {

/// "" for none.
std::string detail_text(Detail detail);

/// "a start from near rest; pulls of the spring by …"; "" where nothing was tried.
std::string larger_tried_text(LargerTried tried);

}  // namespace stickslip
