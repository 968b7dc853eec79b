// One step of Rodas5P for a flow of any size, alone or with its variational equations.
#pragma once
#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/solvers/rodas5p_table.h"

#include <array>

namespace stickslip {

/// A step from y to y_1 with all that events and error control need of it.
struct RodasStep {
    double h = 0;
    FlowVector y, y1;
    std::array<FlowVector, rodas5p::stages> U;

    const FlowVector& error() const { return U[rodas5p::stages - 1]; }
    FlowVector dense(double fraction) const;
};

/// Fills `step` from step.y and step.h.
void rodas5p_step(const Flow& flow, RodasStep& step);

/// The same step together with Φ̇ = J(y) Φ, whose columns are displacements of the start. Order 5 for Φ as well: the
/// Jacobian of the joint system contains ∂(JΦ)/∂y, taken by differences of J. Returns Φ at the end of the step.
FlowMatrix rodas5p_step(const Flow& flow, RodasStep& step, const FlowMatrix& displacements);

/// Largest error over rtol (scale + |y|), component by component; NaN if the step left the domain of the law.
double scaled_error(const RodasStep& step, const FlowVector& scale, double rtol);

/// A first step that resolves both the fastest rate at y and the motion itself.
double first_step(const Flow& flow, const FlowVector& y);

/// Factor for the next step size from the scaled error of a method of order 5(4).
double step_factor(double scaled_error);

}  // namespace stickslip
