// Pages of diagnoses held against each other: two, or many in the order of their dates.
#pragma once
#include "analysis/results/report.h"
#include "analysis/results/table_marks.h"
#include "sweep/study/compare/timeline.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace stickslip {

using Provenance = std::vector<std::pair<std::string, std::string>>;

Report comparison_report(const DiagnosisComparison& comparison, Provenance provenance);

struct TimelinePage {
    Report report;
    TableMarks marks;
};

TimelinePage timeline_report(const Timeline& timeline, Provenance provenance);

}  // namespace stickslip
