// What the loop of the design does as its gain changes: its root locus.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"

#include <vector>

namespace stickslip {

/// The roots over a range of k_p. Empty where the joint has infinitely many (delays, tables) or no steady sliding.
std::vector<Figure> loop_figures(const Joint& joint, double low, double high);

}  // namespace stickslip
