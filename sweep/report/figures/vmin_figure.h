// How slow a joint can go: the minimum stable velocity over both gains.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "sweep/study/linear_details.h"

namespace stickslip {

/// V_min over k_p for several k_v, with memory, and by the velocity-only model, which knows no k_p: the velocity from
/// which on sliding is stable, within the velocities that the study searched. The joint slides steadily.
Figure vmin_figure(const Joint& joint, const LinearDetails& details);

}  // namespace stickslip
