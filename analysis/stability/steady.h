// Steady sliding of a joint at its commanded velocity.
#pragma once
#include "analysis/joint/commanded_velocity.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// The friction of all bodies in joint coordinates, Σ N f_ss(N V_0), and the deflection of the loop that carries it, or
/// the reason why the joint cannot slide steadily at V_0.
SteadySliding steady_sliding(const Joint& joint);

}  // namespace stickslip
