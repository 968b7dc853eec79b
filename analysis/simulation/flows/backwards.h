// Joints that move backwards, whose flows are mirrored: positions and velocities count along the commanded direction.
#pragma once
#include "analysis/friction/friction.h"
#include "analysis/results/disturbance.h"

namespace stickslip {

/// Whether state i has a direction, as one that deflects: one that ages has none.
bool has_direction(const Friction& friction, double V0, std::size_t i);

/// What disturbs the joint, for its flow. `friction` is that of the link.
Disturbance mirrored(Disturbance disturbance, const Friction& friction, double V0);

}  // namespace stickslip
