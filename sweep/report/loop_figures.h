// What the loop of the design does as its gain changes: root locus and slowest smooth velocity.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"

#include <vector>

namespace stickslip {

/// The roots over a range of k_p, and V_min over the same range in both theories. Empty where the joint has
/// infinitely many roots (delays, tables) or no steady sliding.
std::vector<Figure> loop_figures(const Joint& joint, double low, double high);

}  // namespace stickslip
