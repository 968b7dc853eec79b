// A table of measured outcomes from CSV or .csv.gz: at which settings a joint slid and at which it stuck and slipped.
#pragma once
#include "analysis/diagnosis/outcomes/outcome_table.h"

#include <filesystem>

namespace stickslip {

/// Whether a file is a table of outcomes: its header has a column `outcome` and none called `time`. Throws BadInput
/// where there is no text to read.
bool is_outcome_file(const std::filesystem::path& file);

/// Reads a header row and rows of settings. Columns: `outcome` (stable | stable-sliding | stick-slip | limit-cycle, or
/// 0 and 1), `amplitude` (half peak to peak in position, may be empty), and numbers of the joint by their path or their
/// last part (k_p, k_v, V0, force_rate, joint.inertia, …), each with a unit in brackets where it is not SI:
/// "V0 [mm/s]". Other columns are named in `warnings`. Commas, semicolons or tabs; `#` comments above the header.
/// Throws BadInput (`file:line:column: …`, up to 20 errors).
OutcomeTable read_outcomes(const std::filesystem::path& file, const Joint& joint, std::vector<std::string>& warnings);

}  // namespace stickslip
