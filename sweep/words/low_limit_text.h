// A limit that leaves no steady sliding, in words.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/trajectory.h"
#include "analysis/stability/effort_limits.h"

#include <string>

namespace stickslip {

/// "is 50 N, and steady sliding at V_{0} = 1 mm/s takes 60 N (friction 60 N): there is no steady sliding", to stand
/// behind the key and its place.
std::string low_limit_words(const LowLimit& low, const Joint& joint);

/// What low_limit_words() says as a sentence of its own, at the commanded velocity.
std::string low_limit_text(const Joint& joint);

/// Of a motion that was not simulated.
std::string no_motion_text(const Joint& joint, const Trajectory& motion);

/// Why a simulation has no motion, or ends before its time.
std::string stop_text(const Trajectory& motion);

}  // namespace stickslip
