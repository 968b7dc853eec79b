// One trajectory of one joint.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/trajectory.h"
#include "analysis/simulation/disturbance.h"

namespace stickslip {

struct SimulateOptions {
    Disturbance disturbance;
    double duration = missing;  ///< s; not set: fifty turns of the slowest mode, up to 400 where it grows slowly
    double force = 0;           ///< constant force d from t = 0 on, N
    double rtol = 1e-8;
    bool fallback_only = false;  ///< Rodas5P in place of CVODE
};

/// Integrates the joint from its disturbance on and keeps every step of the solver. Never throws: a joint without
/// equations of motion gives an empty trajectory and the reason, a solver that fails the part that it reached.
Trajectory simulate(const Joint& joint, const SimulateOptions& options);

}  // namespace stickslip
