// A report as files: report.html, and beside it the pictures and data of each chart.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/spec.h"

#include <filesystem>

namespace stickslip {

/// Renders the report into the directory, each file whole or not at all, and returns the path of the page.
/// Throws std::filesystem::filesystem_error if it cannot be written.
std::filesystem::path write_report(const Report& report, const std::filesystem::path& directory);

/// The report of a sweep, and beside it what the page's commands run on: joint.toml, the design; of a joint in a robot
/// also spec.toml, `text`, which needs no other file.
std::filesystem::path write_sweep_report(const Report& report, const Spec& spec, const std::string& text,
                                         const std::filesystem::path& directory);

}  // namespace stickslip
