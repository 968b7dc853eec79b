// The page of a table of outcomes: which law explains them, and the rows on each law's boundary.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/outcome_answer.h"
#include "sweep/study/stable_windows.h"

namespace stickslip {

/// `maps` are those of the answer, and `moved` the boundary by its best law; none where it has no laws.
Report outcome_report(const gap::OutcomeAnswer& answer, const OutcomeMaps& maps, const Joint& nominal,
                      const MovedBoundary& moved, std::vector<std::pair<std::string, std::string>> provenance);

}  // namespace stickslip
