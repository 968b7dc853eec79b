// Options that take one of a few words.
#pragma once
#include "sweep/program/verbs/command_line.h"

#include <string>
#include <vector>

namespace stickslip {

std::string in_quotes(const std::string& text);
/// "a, b, c"
std::string listed(const std::vector<std::string>& names);
/// "; did you mean k_p?", empty where nothing known is near.
std::string did_you_mean(const std::string& given, const std::vector<std::string>& known);

/// One of the words; the error says what it got, all of them and the nearest.
Check one_of(const std::vector<std::string>& words);
/// One of the words or a file that exists.
Check one_of_or_file(const std::vector<std::string>& words);

}  // namespace stickslip
