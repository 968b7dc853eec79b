// One motion of a joint in its real loop, or under what has no steady sliding: gravity, cogging, ripple, a periodic
// force, drift.
#pragma once
#include "analysis/results/disturbance.h"
#include "analysis/results/trajectory.h"
#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"

namespace stickslip {

struct LoopMotionQuestion {
    Disturbance disturbance;
    double duration = missing;      ///< s; not set: fifty turns
    double cycle_period = missing;  ///< s, of the cycle that the motion ends in, where it is known
    double rtol = 1e-8;
    std::uint64_t seed = 1;  ///< of the noise
};

/// The loop moving at V_0 from balance on, disturbed; every step of the integration.
Trajectory loop_trajectory(const Joint& joint, const LoopMotionQuestion& question);

}  // namespace stickslip
