// The next experiment in words.
#pragma once
#include "analysis/results/diagnosis.h"

#include <string>
#include <string_view>

namespace stickslip {

/// "a sine of small amplitude with many reversals"; empty where no motion was found.
std::string_view motion_text(TestMotion motion);

/// Whether it is a motion to be made: one that would show which of two causes acts.
bool has_motion(const NextExperiment& experiment);

/// For the page: which causes it tells apart and by how much, what a machine must bear, or why there is none.
std::string next_experiment_text(const Diagnosis& diagnosis);

}  // namespace stickslip
