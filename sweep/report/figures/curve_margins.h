// What followed curves say of the design point, and how sharply each of their points is located.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/results/report.h"

#include <string>
#include <vector>

namespace stickslip {

/// One number for each ray, and for each curve and axis on which it lies before or behind the design, read from the
/// curve between its neighbouring points.
std::vector<Headline> meeting_headlines(const Joint& design, const std::vector<LocatedRay>& rays,
                                        const std::vector<FollowedBoundary>& curves);

/// "Through the design along k_{p}: linear boundary with memory at 19.45 kN/m, fold of limit cycles at 24.85 kN/m."
std::string meeting_text(const Joint& design, const std::vector<FollowedBoundary>& curves);

/// Relative bracket width of every located point of the curves of one chart, along x.
Figure precision_figure(const std::vector<FollowedBoundary>& curves, Motion motion);

/// A curve as a chart draws it; where a bracket would be wider than a line, both its ends are drawn as well.
Curve curve_with_brackets(const FollowedBoundary& boundary);

}  // namespace stickslip
