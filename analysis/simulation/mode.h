// The slowest mode of steady sliding in the variables of a flow, and disturbances that excite it.
#pragma once
#include "analysis/simulation/disturbance.h"
#include "analysis/simulation/flow.h"

#include <complex>

namespace stickslip {

/// A change of ln|l·y| over the window of less than 1/clear_change is measured with finer tolerances: what a step adds
/// or takes by its error must be small beside it.
inline constexpr double clear_change = 5;

/// The eigenvalue of largest real part and its left eigenvector: along a trajectory near steady sliding,
/// l·(y − y_ss) = l·(y_0 − y_ss) e^{st} holds exactly, whatever the other modes do.
struct SlowMode {
    std::complex<double> s{missing, missing};
    Eigen::VectorXcd left;
    FlowVector steady;

    /// |l·(y − y_ss)|
    double size(const FlowVector& y) const
    {
        return std::abs((left.transpose() * (y - steady).cast<std::complex<double>>())(0));
    }
    /// Over which the growth of a small disturbance is measured: one turn, or a factor of 3 if that comes first.
    double window() const;
};
SlowMode slow_mode(const Flow& flow);

/// The size that is meant where none is given; only for kinds `position`, `velocity`, `impulse` and `offset`.
double default_size(const SlidingFlow& flow, const SlowMode& mode, DisturbanceKind kind);

/// The state right after the disturbance.
FlowVector disturbed(const SlidingFlow& flow, DisturbanceKind kind, double size);

}  // namespace stickslip
