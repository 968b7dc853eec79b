// The page of a table of outcomes: which law explains them, and the rows on each law's boundary.
#pragma once
#include "analysis/diagnosis/outcomes/explain.h"
#include "analysis/results/report.h"

namespace stickslip {

/// The answer in one sentence, for the terminal and the top of the page.
std::string outcome_sentence(const gap::OutcomeAnswer& answer);

/// Next experiment in words; empty where nothing is left to distinguish.
std::string next_outcome_text(const gap::OutcomeAnswer& answer);

Report outcome_report(const gap::OutcomeAnswer& answer, const Joint& nominal,
                      std::vector<std::pair<std::string, std::string>> provenance);

}  // namespace stickslip
