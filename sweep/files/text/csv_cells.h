// Cells of a CSV line. Internal to sweep/files.
#pragma once
#include <string_view>

namespace stickslip::files {

std::string_view trimmed(std::string_view text);

/// A cell as a number: empty, nan or NA is a missing value (NaN). False for anything else that is no finite number.
bool parse_cell(std::string_view cell, double& value);

/// Whether points in place of commas would make it a number.
bool has_decimal_comma(std::string_view cell);

/// Said of such a cell, and of a row with twice the cells of its header, separated by commas.
inline constexpr const char* decimal_commas = "; these seem to be decimal commas, write decimal points";

}  // namespace stickslip::files
