// The page of one joint: everything that the linear theory says of it.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "sweep/study/gain_chart.h"
#include "sweep/study/joint_answer.h"

#include <vector>

namespace stickslip {

/// Comparison of the theories, disturbances and margins, force ramps, reductions: the sections that the joint has.
/// Empty without steady sliding.
std::vector<Section> linear_sections(const Joint& joint, const LinearDetails& details);

/// Stable k_p under the paper's loop and in the joint's own.
struct BothLoops {
    std::vector<Interval> ideal, real;
};

/// What the paper's loop allows beside what the joint's own does: the first chart of a joint with a real loop.
Section gains_section(Units units, const BothLoops& stable, const GainChart& chart);

/// Verdict, sections and tables of one joint.
Report linear_report(const Joint& joint, const JointAnswer& answer);

}  // namespace stickslip
