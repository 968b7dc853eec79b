// Limit cycles of a smooth flow by shooting: Newton on the return map of V = V_0, with variational equations, so that
// existence, stability and period doublings are computed rather than watched.
#pragma once
#include "analysis/simulation/flows/flow.h"
#include "analysis/simulation/solvers/work.h"

#include <optional>

namespace stickslip {

struct CycleOptions {
    double rtol = 1e-10;
    int turns = 1;  ///< of the orbit around the section: 2 for an orbit of twice the period
    int newton_steps = 20;
    double closure = 1e-9;   ///< largest gap of a closed cycle, in units of the flow's scale
    int step_limit = 50000;  ///< of one revolution; thousands are usual
    Work* work = nullptr;    ///< that steps may take; none: as much as they need
};

/// A closed orbit. It starts where V falls through V_0, that is at its largest position.
struct Cycle {
    FlowVector start;
    double period = missing;
    double velocity_min = missing, velocity_max = missing;
    double position_min = missing, position_max = missing;
    double rest_time = 0;          ///< below near_rest · V_0
    Eigen::VectorXcd multipliers;  ///< Floquet, without the trivial one, largest modulus first

    double amplitude() const { return 0.5 * (position_max - position_min); }
    bool attracts() const { return multipliers.size() > 0 && std::abs(multipliers[0]) < 1; }
};

/// One revolution from a point of the section: where it returns and how displacements of the start arrive there.
struct Revolution {
    Cycle path;  ///< start, period and extrema of this revolution; not closed in general
    FlowVector end;
    FlowMatrix displacement;  ///< ∂(state at the fixed time of return)/∂(start)
};

/// Follows one revolution from `start`, which lies on the section moving down; nothing if it never returns.
std::optional<Revolution> revolve(const Flow& flow, const FlowVector& start, const CycleOptions& options);

/// Newton from a guess on or near the section. Nothing if it does not converge, or converges to steady sliding itself.
std::optional<Cycle> find_cycle(const Flow& flow, const FlowVector& guess, const CycleOptions& options);

/// Floquet multipliers of a closed revolution: eigenvalues of the return map on the section.
Eigen::VectorXcd floquet_multipliers(const Flow& flow, const Revolution& closed);

}  // namespace stickslip
