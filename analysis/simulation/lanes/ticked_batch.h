// Joints in sampled loops that lanes follow, and what they answer.
#pragma once
#include <span>

#include "analysis/simulation/lanes/job.h"
#include "analysis/simulation/sampled/loop_verdict.h"

namespace stickslip::lanes {

struct TickedJob;

/// One mass under the slip or the ageing law with one state and nothing else, behind a drive whose effort is linear in
/// velocity and, where it lags, in the command. The controller, its encoder and its dead time are any that a loop can
/// have.
bool in_ticked_lanes(const Joint& joint);

/// Verdicts on such joints, in the order given; `answered` is false where the motion of one could not be followed.
/// Growth rates are those of the linear loop. Each depends on its joint alone, bit by bit, for an instruction set.
void answer_ticked(std::span<const Joint* const> joints, const LoopQuestion& question, std::span<LoopVerdict> verdicts,
                   bool* answered, Instructions instructions);

}  // namespace stickslip::lanes
