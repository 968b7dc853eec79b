// Names in messages: those there are, and the one that was meant.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::files {

/// `; did you mean "x"?`, or nothing where no name comes close.
std::string did_you_mean(std::string_view given, const std::vector<std::string>& known);

/// "a, b, c"
std::string listed(const std::vector<std::string>& names);

}  // namespace stickslip::files
