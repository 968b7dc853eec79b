// The velocity at which a joint is commanded to slide, and that at which it does.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// V_0: control.V0, or force_rate / (k_p + k_c) where force control ramps at a given rate. NaN if neither is set.
double commanded_velocity(const Joint& joint);

/// The velocity of steady sliding: a position loop that reads `sensor.position_scale` per displacement follows V_0 by
/// its reading, and slides at V_0 / scale. Force control reads no position.
double sliding_velocity(const Joint& joint);

}  // namespace stickslip
