// What to write in place of a friction law that no record is fitted with.
#pragma once
#include "analysis/results/not_fitted.h"

#include <string>

namespace stickslip {

std::string not_fitted_text(const NotFitted& refused);

}  // namespace stickslip
