// A revolution by Taylor series: where friction is the slip law alone, ln V makes the equations of motion products of
// few functions, whose series of any order follow by recurrence, together with those of the variational equations.
// Method: Jorba & Zou, Experimental Mathematics 14 (2005) 99 (step from the last coefficients).
#pragma once
#include "analysis/simulation/attractor/cycle.h"

namespace stickslip {

/// What revolve() returns, for a joint of one or two states of the slip law with nothing beside it. Nothing where the
/// joint is another, or the motion is too stiff for series: it has to be followed step by step then.
std::optional<Revolution> series_revolution(const Flow& flow, const FlowVector& start, const CycleOptions& options);

}  // namespace stickslip
