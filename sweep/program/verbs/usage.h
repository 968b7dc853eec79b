// The message for a wrong command line: what was given, what is allowed, the nearest name, and an example.
#pragma once
#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace stickslip {

/// The message for a command line that CLI11 refused, several lines, each ended. `arguments` without the program's
/// name.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& arguments);

}  // namespace stickslip
