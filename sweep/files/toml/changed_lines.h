// What differs between two files of one program, for a user who will type it.
#pragma once
#include <string>
#include <string_view>

namespace stickslip {

/// The lines "key = value" of `after` that `before` has not, under the headers of their tables, with the value before
/// in a comment, seven digits of a number. Both as joint_text writes them.
std::string changed_lines(std::string_view before, std::string_view after);

}  // namespace stickslip
