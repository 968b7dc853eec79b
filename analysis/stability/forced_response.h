// The linear joint under a disturbance in time: d(t) of (9), answered by (19).
#pragma once
#include <cstdint>
#include <vector>

#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// A disturbing force on the link: `value[i]` holds from i·step to (i + 1)·step.
struct SampledForce {
    double step = 0;            ///< s
    std::vector<double> value;  ///< N | N·m
    double impulse = 0;         ///< N·s, before the first sample
};

enum class ForceKind { impulse, step, sine, noise };

/// `size` is N·s for an impulse, N for the others: the level of a step, the amplitude of a sine, the standard deviation
/// of noise (one independent normal sample a step, from `seed`). `omega` is that of a sine [rad/s].
SampledForce sampled_force(ForceKind kind, double size, double duration, double step, double omega = 0,
                           std::uint64_t seed = 1);

/// Position and velocity of the link in excess of steady sliding at the end of each step, and at the start.
struct ForcedResponse {
    std::vector<double> time, position, velocity;  ///< s, [m | rad], [m/s | rad/s]
};

/// Exact at the sample times for a force held between them (matrix exponential), but for a joint with delays or tables,
/// whose steps have an error of the fourth order (delayed_response). The joint starts in steady sliding.
ForcedResponse forced_response(const LinearJoint& joint, const SampledForce& force);

}  // namespace stickslip
