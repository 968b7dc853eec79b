// What a diagnosis does at each of its stages, in words.
#pragma once
#include "analysis/results/diagnosis_stage.h"

#include <string>
#include <string_view>
#include <vector>

namespace stickslip {

/// "fitting single effects".
std::string_view stage_text(DiagnosisStage stage);

/// "fitting pairs, and before climbing the ladder, …": the stage of an interruption and those that it left out, which
/// not every diagnosis needs. By their codes; a text that is no code stays.
std::string stages_text(const std::vector<std::string>& codes);

/// "about 40 s left", "about 3 min left" after so many seconds of which this part of the work was done; empty where too
/// little is done to tell, or nothing is left.
std::string time_left_text(double done, double seconds);

}  // namespace stickslip
