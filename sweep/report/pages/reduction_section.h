// Accuracy of the paper's reductions for one joint: both boundaries in one chart, the error between them, and where
// each assumption breaks.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "analysis/stability/reduction_study.h"

namespace stickslip {

/// Two charts a reduction and one table over all; empty figures for a single mass.
Section reduction_section(const Joint& joint, const std::vector<ReductionStudy>& studies);

}  // namespace stickslip
