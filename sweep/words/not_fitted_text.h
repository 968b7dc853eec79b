// What to write in place of a friction law that no record is fitted with.
#pragma once
#include "analysis/results/not_fitted.h"

#include <string>

namespace stickslip {

std::string not_fitted_text(const NotFitted& refused);

/// What an argument was refused for: the words for its code, or where it has none what the thrower wrote.
std::string refusal_text(const std::invalid_argument& refused);

}  // namespace stickslip
