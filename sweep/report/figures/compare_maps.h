// Maps of the difference between two slices of one grid.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/compare/compare_sweeps.h"

#include <array>
#include <string>
#include <vector>

namespace stickslip {

/// How a point changed, in the order of the legend.
enum class Change { smooth, stick_slip, became_smooth, became_stick_slip, bistable, undecided };
inline constexpr std::size_t changes = 6;

Change change_of(Region before, Region after);

/// The share of a chart's area, axes as drawn, for each change.
std::array<double, changes> change_shares(const Slice& before, const Slice& after);

/// Two figures: what each point became, and by how much its decay changed. Both with the boundaries before (dashed) and
/// after (solid).
std::vector<Figure> change_figures(const SweepComparison& comparison, const ComparedMap& map);

}  // namespace stickslip
