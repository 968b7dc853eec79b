// The motion of a load point that would tell two laws of a friction rig apart.
#pragma once
#include "analysis/diagnosis/rig/rig_laws.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// Simulates both laws along velocity steps down and up and along a hold, and keeps the motion in which they differ
/// most. `noise`: standard deviation of the friction; the distance is the largest difference in it.
NextExperiment design_rig_experiment(const Rig& rig, double noise, RigLaw one, const RigNumbers& p, RigLaw other,
                                     const RigNumbers& q);

}  // namespace stickslip::gap
