// The columns of a table of logs, before it is read.
#pragma once
#include <string>
#include <vector>

namespace stickslip {

/// Names in the first row that is neither empty nor a `#` comment, of a CSV or .csv.gz; empty where there is none.
/// Throws BadInput where the file cannot be read.
std::vector<std::string> table_columns(const std::string& file);

}  // namespace stickslip
