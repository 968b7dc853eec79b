// Baselines as JSON, and the outcome of a check as JUnit XML.
#pragma once
#include "sweep/study/check/boundaries.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stickslip {

/// Reads a baseline. Throws BadInput naming file and position for anything that is not one.
std::vector<WatchedBoundary> read_baseline(const std::filesystem::path& file);

/// The joint's numbers that a baseline was made with; empty of one that was written before it stored them.
std::map<std::string, double> read_baseline_numbers(const std::filesystem::path& file);

/// Whether the design itself was stable; nothing where it had no verdict, or in a baseline without it.
std::optional<bool> read_baseline_design(const std::filesystem::path& file);

/// Writes a baseline beside the old one, then replaces it. Throws
/// std::filesystem::filesystem_error if the place cannot be written.
void write_baseline(const std::filesystem::path& file, const std::string& title,
                    const std::vector<WatchedBoundary>& watched, const std::map<std::string, double>& numbers,
                    std::optional<bool> design_stable);

/// One JUnit test case a boundary, and one for the design, which fails where it was stable and is not.
void write_junit(const std::filesystem::path& file, const std::string& title, const std::vector<Deviation>& deviations,
                 bool design_lost);

/// Text as XML holds it between tags and in attributes.
std::string escaped_xml(const std::string& text);

/// "moved by 3.1e-03 (allowed 1.0e-06): 55000 → 55170 N/m"
std::string describe(const Deviation& deviation);

}  // namespace stickslip
