// That an answer lacks a part, as the first thing that is said of it.
#pragma once
#include <string>

namespace stickslip {

struct NonlinearVerdict;

/// One sentence about an outcome that is undecided, with the reason, before the verdict on small disturbances.
std::string open_text(const NonlinearVerdict& verdict);

}  // namespace stickslip
