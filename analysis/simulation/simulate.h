// One trajectory of one joint.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/disturbance.h"
#include "analysis/results/trajectory.h"
#include "analysis/stability/forced_response.h"

#include <string>

namespace stickslip {

/// What disturbs the joint, for how long it is followed, and how closely.
struct SimulateOptions {
    Disturbance disturbance;        ///< at the start
    double duration = missing;      ///< s; not set: fifty turns of the slowest mode, up to 400 where it grows slowly
    double cycle_period = missing;  ///< s, of the cycle that the motion ends in; not set: nothing waits for a cycle
    SampledForce force;             ///< disturbing force d(t) on the link, (9), on top of the disturbance
    SampledLoad normal_load;        ///< normal load over time, as a ratio; empty: as the joint says
    double rtol = 1e-8;             ///< relative tolerance of the solver
    std::uint64_t seed = 1;         ///< of the noise of a real loop
    bool fallback_only = false;     ///< Rodas5P in place of CVODE

    /// What is wrong with them; empty if nothing.
    std::string problem() const;
};

/// Integrates the joint from its disturbance on and keeps every step of the solver. With a normal load the joint slides
/// steadily under the first one before, and positions are in excess of that path. A joint without
/// equations of motion gives an empty trajectory and the reason, a solver that fails the part that it reached. Throws
/// std::invalid_argument for options with a problem(), and for nothing else.
Trajectory simulate(const Joint& joint, const SimulateOptions& options);

}  // namespace stickslip
