// Steady sliding of a joint at its commanded velocity.
#pragma once
#include "analysis/stability/verdict.h"

namespace stickslip {

/// V_0: control.V0, or force_rate / k_p where force control ramps at a given rate. NaN if neither is set.
double commanded_velocity(const Joint& joint);

/// f_ss(V_0) and the deflection that carries it, or the reason why the joint cannot slide steadily at V_0.
SteadySliding steady_sliding(const Joint& joint);

}  // namespace stickslip
