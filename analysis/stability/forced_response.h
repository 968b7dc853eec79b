// The linear joint under a disturbing force d(t) on the link, (9) of the paper: the answer is that of its transfer
// function X/D(s), (19).
#pragma once
#include <cstdint>
#include <vector>

#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// A disturbing force on the link: `value[i]` holds from i·step to (i + 1)·step.
struct SampledForce {
    double step = 0;            ///< s
    std::vector<double> value;  ///< N | N·m
    double impulse = 0;         ///< N·s | N·m·s, before the first sample
};

/// The course of a disturbing force in time.
enum class ForceKind { impulse, step, sine, noise };

/// `size` is N·s for an impulse, N for the others: the level of a step, the amplitude of a sine, the standard deviation
/// of noise (one independent normal sample a step, from `seed`). `omega` is that of a sine [rad/s]. `duration` and
/// `step` in s; throws std::invalid_argument unless 0 < step ≤ duration.
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
