// The page of a table of outcomes: which law explains them, and the rows on each law's boundary.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/outcome_answer.h"

namespace stickslip {

/// `maps` are those of the answer; none where it has no laws.
Report outcome_report(const gap::OutcomeAnswer& answer, const OutcomeMaps& maps, const Joint& nominal,
                      std::vector<std::pair<std::string, std::string>> provenance);

}  // namespace stickslip
