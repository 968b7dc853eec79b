// Diagnoses of one joint in the order of their dates.
#pragma once
#include "sweep/study/compare/compare_diagnoses.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

using Timestamp = std::chrono::sys_seconds;

struct DatedDiagnosis {
    Timestamp at;
    DiagnosisFacts facts;
    std::string page;  ///< its own, from the timeline's folder; empty where it has none
};

/// One number over all runs; NaN where a run does not name it.
struct NumberSeries {
    std::string name, unit;
    FoundNumber::Of of = FoundNumber::Of::parameter;
    std::vector<double> value, standard_error;  ///< one each run
    int found = 0;                              ///< in how many runs
};

struct Timeline {
    std::string title;  ///< of the joint; may be empty
    std::vector<DatedDiagnosis> runs;
    std::vector<DiagnosisComparison> steps;  ///< each run with the one before it
    std::vector<NumberSeries> numbers;       ///< of the causes, those in most runs first
};

/// Sorts the runs by date.
Timeline timeline_of(std::string title, std::vector<DatedDiagnosis> runs);

/// "2026-03-01", "2026-03-01T14-30", "20260301_143000" anywhere in a name; nothing where there is no date of the
/// calendar in it.
std::optional<Timestamp> date_in(std::string_view name);

/// "2026-03-01", with the time of day where it is not midnight.
std::string date_text(Timestamp at);

/// Days from one instant to another.
double days_between(Timestamp from, Timestamp to);

}  // namespace stickslip
