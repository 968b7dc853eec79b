// Two diagnoses held against each other, and a check of a gap, in plain words.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/check/gap_check.h"
#include "sweep/study/compare/compare_diagnoses.h"

#include <string>

namespace stickslip {

/// "gap by coulomb-level", "no gap", "too little data".
std::string outcome_name(const DiagnosisFacts& facts);

/// "gap by coulomb-level, 2.1 times the noise floor", "no gap", "too little data".
std::string outcome_words(const DiagnosisFacts& facts);

/// "The gap is new: 2.1 times the noise floor by coulomb-level. …": what stands first on page and terminal.
std::string comparison_sentence(const DiagnosisComparison& c);

/// One change stands in the cause's parameter and in the data-sheet number that it makes: the latter is shown.
bool is_reported(const NumberChange& change, const DiagnosisComparison& step);

/// "Coulomb level: 1.1000 ± 0.0007 N·m → 1.2100 ± 0.0007 N·m, 111 standard errors"
std::string change_text(const NumberChange& change);

/// "a gap that the baseline does not have: 2.1 times the noise floor by coulomb-level"
std::string regression_text(const GapRegression& regression, const DiagnosisComparison& c);

Table changes_table(const DiagnosisComparison& c);
Table compared_gap_table(const DiagnosisComparison& c);

}  // namespace stickslip
