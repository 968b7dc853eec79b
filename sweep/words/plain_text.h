// Chart mark-up as a terminal shows it.
#pragma once
#include <string>

namespace stickslip {

/// "k_{cr}" reads k_cr, "10^{−6}" reads 10^−6.
std::string plain_text(const std::string& markup);

}  // namespace stickslip
