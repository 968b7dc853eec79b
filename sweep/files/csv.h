// Cells of a CSV line. Internal to sweep/files.
#pragma once
#include <string_view>

namespace stickslip::files {

std::string_view trimmed(std::string_view text);

/// A cell as a number: empty, nan or NA is a missing value (NaN). False for anything else that is no finite number.
bool parse_cell(std::string_view cell, double& value);

}  // namespace stickslip::files
