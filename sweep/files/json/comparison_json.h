// Two diagnoses compared, a check of a gap with its baseline, and many dated diagnoses: documented, stable names.
#pragma once
#include "sweep/study/check/gap_check.h"
#include "sweep/study/compare/compare_diagnoses.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace stickslip {

/// "new-gap", "grown", "remainder", "new-cause", "number-moved" or "no-answer".
std::string name_of(GapRegression::Kind kind);
/// "sheet", "parameter" or "correction".
std::string name_of(FoundNumber::Of of);

/// "stickslip-comparison/1"
nlohmann::ordered_json comparison_json(const DiagnosisComparison& comparison);

/// "stickslip-gap-check/1"
nlohmann::ordered_json gap_check_json(const GapCheck& check);

/// Verdict, causes, gap and numbers of one diagnosis, as they stand in comparisons and timelines.
nlohmann::ordered_json facts_json(const DiagnosisFacts& facts);

struct GapBaseline {
    std::string joint;  ///< joint.toml as it was, every key that is not at its default
    DiagnosisFacts diagnosis;
};

/// Throws BadInput for anything that is not a baseline of a gap.
GapBaseline read_gap_baseline(const std::filesystem::path& file);

/// `diagnosis` is diagnosis.json.
void write_gap_baseline(const std::filesystem::path& file, const std::string& joint, const std::string& diagnosis);

/// One test case for the gap and one for each regression.
void write_gap_junit(const std::filesystem::path& file, const std::string& joint, const GapCheck& check);

}  // namespace stickslip
