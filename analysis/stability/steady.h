// Steady sliding of a joint at its commanded velocity.
#pragma once
#include "analysis/joint/commanded_velocity.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// The friction of all bodies in joint coordinates, Σ N f_ss(N V) at the velocity V at which the joint slides, and the
/// deflection of the loop that carries it, or the reason why the joint cannot slide steadily there.
SteadySliding steady_sliding(const Joint& joint);

/// Size of that deflection as a displacement of the joint: a position loop counts it in what its encoder reads.
double displaced(const Joint& joint, const SteadySliding& sliding);

}  // namespace stickslip
