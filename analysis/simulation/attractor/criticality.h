// Of a joint whose region is known: criticality of its Hopf point, and the gain at which its cycles end.
// Internal to analysis/simulation/attractor.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/simulation/flows/flow.h"

namespace stickslip {

/// Criticality at k_cr, and the fold: from a subcritical Hopf point, or from the cycle that a bistable joint has.
void add_bifurcation(const Joint& joint, const Flow& flow, const FlowVector& cycle_start, NonlinearVerdict& verdict);

}  // namespace stickslip
