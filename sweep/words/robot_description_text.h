// What a robot's description has and no robot can, in plain words.
#pragma once
#include "analysis/results/stability_map.h"
#include "sweep/study/import/import.h"

#include <string>
#include <vector>

namespace stickslip {

/// Sentence.
std::string impossible_inertia_text(const ImpossibleInertia& of);

/// Sentence.
std::string suspected_unit_text(const SuspectedUnit& of);

/// Sentence: an element of the description that the joint file lacks, and why.
std::string not_taken_text(const NotTaken& of);

/// Sentence without full stop: joint, where it stands, its limits.
std::string beyond_limits_text(const PoseBeyondLimits& of);

/// Sentences without full stop: axes of a sweep that go beyond the limits of another joint of the robot.
std::vector<std::string> unreachable_poses_text(const Joint& joint, const std::vector<Axis>& axes);

}  // namespace stickslip
