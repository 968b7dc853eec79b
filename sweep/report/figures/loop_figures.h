// What the loop of the design does as its gain changes: its root locus.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/root_locus.h"

#include <vector>

namespace stickslip {

/// The roots over a range of k_p. Empty where there is no locus or nothing of it to see.
std::vector<Figure> loop_figures(const std::optional<RootLocus>& locus, Units units);

}  // namespace stickslip
