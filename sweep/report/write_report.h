// A report as files: report.html, and beside it the pictures and data of each chart.
#pragma once
#include "analysis/results/report.h"

#include <filesystem>

namespace stickslip {

/// Renders the report into the directory, each file whole or not at all, and returns the path of the page.
/// Throws std::system_error if it cannot be written.
std::filesystem::path write_report(const Report& report, const std::filesystem::path& directory);

}  // namespace stickslip
