// The velocity at which a joint is commanded to slide.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// V_0: control.V0, or force_rate / (k_p + k_c) where force control ramps at a given rate. NaN if neither is set.
double commanded_velocity(const Joint& joint);

}  // namespace stickslip
