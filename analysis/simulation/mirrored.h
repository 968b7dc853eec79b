// Joints that move backwards, whose flows are mirrored: what a simulation does to them, and the motion that comes of
// it.
#pragma once
#include "analysis/friction/friction.h"
#include "analysis/results/trajectory.h"
#include "analysis/simulation/simulate.h"

namespace stickslip {

/// What disturbs the joint, for its flow, whose positions count along the commanded direction. `friction` is that of
/// the link.
SimulateOptions mirrored(SimulateOptions options, const Friction& friction, double V0);

/// The motion of a mirrored flow as the joint makes it.
void mirror(Trajectory& path, const Friction& friction);

}  // namespace stickslip
