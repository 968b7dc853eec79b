// The heart of the paper on a page: what the velocity-only model and friction with memory require of one joint.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "sweep/study/linear_details.h"

namespace stickslip {

/// Both theories side by side: demanded k_v over velocity, stable gains, what one forbids and the other allows, the mix
/// of gains. The joint slides steadily.
Section comparison_section(const Joint& joint, const LinearDetails& details);

/// |X/D|(iω) of (19) with its peak in both theories, and the margins of the loop.
Section response_section(const Joint& joint, const LinearDetails& details);

/// Armstrong's ramps (§5): critical stiffness and velocity over the rate of force. Force control only.
Section ramp_section(const Joint& joint, const LinearDetails& details);

}  // namespace stickslip
