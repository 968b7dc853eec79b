// The page of one joint: everything that the linear theory says of it.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "sweep/study/joint_answer.h"

#include <vector>

namespace stickslip {

/// Comparison of the theories, disturbances and margins, force ramps, reductions: the sections that the joint has.
/// Empty without steady sliding.
std::vector<Section> linear_sections(const Joint& joint, const LinearDetails& details);

/// Verdict, sections and tables of one joint.
Report linear_report(const Joint& joint, const JointAnswer& answer);

}  // namespace stickslip
