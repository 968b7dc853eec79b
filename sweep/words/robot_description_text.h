// What a robot's description has and no robot can, in plain words.
#pragma once
#include "sweep/study/import/import.h"

#include <string>

namespace stickslip {

/// Sentence.
std::string impossible_inertia_text(const ImpossibleInertia& of);

/// Sentence.
std::string suspected_unit_text(const SuspectedUnit& of);

/// Sentence: an element of the description that the joint file lacks, and why.
std::string not_taken_text(const NotTaken& of);

/// Sentence without full stop: joint, where it stands, its limits.
std::string beyond_limits_text(const PoseBeyondLimits& of);

}  // namespace stickslip
