// File names in commands that users paste into a shell.
#pragma once
#include <string>

namespace stickslip {

/// The text as one word of a shell: as it is where that is safe, else in single quotes.
std::string shell_word(const std::string& text);

}  // namespace stickslip
