// The joint under a disturbance in time, on a page.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/disturbed_motion.h"

namespace stickslip {

Figure disturbance_figure(const Joint& joint, const AskedDisturbance& asked, const DisturbedMotion& motion);

}  // namespace stickslip
