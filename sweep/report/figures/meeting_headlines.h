// What followed curves say of the design point, and how sharply each of their points is located.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/report.h"
#include "sweep/study/meetings.h"

#include <string>
#include <vector>

namespace stickslip {

/// How far the design is from the boundaries that it meets along one of its numbers.
std::vector<Headline> meeting_headlines(const std::vector<Meeting>& meetings, Units units);

/// "Through the design along k_{p}: linear boundary with memory at 19.45 kN/m, fold of limit cycles at 24.85 kN/m."
std::string meeting_text(const std::vector<Meeting>& meetings, Units units);

/// Relative bracket width of every located point of the curves of one chart, along x.
Figure precision_figure(const std::vector<FollowedBoundary>& curves, Units units);

/// A curve as a chart draws it; where a bracket would be wider than a line, both its ends are drawn as well.
Curve curve_with_brackets(const FollowedBoundary& boundary);

}  // namespace stickslip
