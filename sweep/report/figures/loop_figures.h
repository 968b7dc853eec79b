// What the loop of the design does as its gain changes: its root locus.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"

#include <vector>

namespace stickslip {

/// The roots over a range of k_p, the rightmost ones where they have no end (delays, tables). Empty without steady
/// sliding.
std::vector<Figure> loop_figures(const Joint& joint, double low, double high);

}  // namespace stickslip
