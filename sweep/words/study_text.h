// Why numbers of the linear study are missing, in words.
#pragma once
#include "sweep/study/study_reasons.h"

#include <string>
#include <vector>

namespace stickslip {

std::string study_text(StudyReason reason);

/// Several at once; "" for none.
std::string velocities_text(const std::vector<StudyReason>& reasons);
std::string margins_reason_text(const std::vector<StudyReason>& reasons, double searched_to);

/// Why a reduction was not compared.
std::string refused_text(const ReductionStudy& reduction);

/// Of a reduction without an error, with the range and what was found there.
std::string error_text(const ReductionStudy& reduction);

/// "2.1 %", or why boundaries of full and reduced joint were not compared.
std::string reduction_error_text(double error);

/// What eigenvalues are that are not all of them.
std::string rightmost_roots_text();

}  // namespace stickslip
