// The slowest mode of steady sliding in the variables of a flow, and disturbances that excite it.
#pragma once
#include "analysis/results/disturbance.h"
#include "analysis/simulation/flows/chain_flow.h"
#include "analysis/simulation/flows/growth_window.h"

#include <complex>

namespace stickslip {

/// |s| of a mode that cannot be distinguished from zero, per largest |s|: what rounding makes of an eigenvalue.
inline constexpr double neutral_mode = 1e-14;

/// The eigenvalue of largest real part and its eigenvectors: along a trajectory near steady sliding,
/// l·(y − y_ss) = l·(y_0 − y_ss) e^{st} holds exactly, whatever the other modes do. States that rest wherever they are
/// left, like the yielded elements of a slip model, are no modes.
struct SlowMode {
    std::complex<double> s{missing, missing};
    Eigen::VectorXcd left, right;
    FlowVector steady;
    double fastest = missing;  ///< largest |s| of all modes

    /// False where there is no mode, or none that moves on the clock of the others, as of a joint without a position
    /// gain: no simulation can distinguish growth from decay there.
    bool shows_itself() const { return std::abs(s) >= neutral_mode * fastest && std::isfinite(fastest); }

    /// |l·(y − y_ss)|
    double size(const FlowVector& y) const
    {
        return std::abs((left.transpose() * (y - steady).cast<std::complex<double>>())(0));
    }
    double window() const { return growth_window(s); }
};
SlowMode slow_mode(const Flow& flow);

/// The smallest |s| of a mode, the largest, and the largest Re s; states that do not evolve are no modes.
struct LinearRates {
    double slowest = infinity, fastest = 0, abscissa = -infinity;
};
LinearRates linear_rates(const Flow& flow);

/// The size that is meant where none is given.
double default_size(const SlidingFlow& flow, const SlowMode& mode, DisturbanceKind kind);
double default_size(const ChainFlow& flow, const SlowMode& mode, DisturbanceKind kind);

/// The state right after the disturbance, which acts on the link. Several bodies: `position` and `velocity` displace
/// the joint along its slow mode, so far that the link has that position or velocity more; `offset` moves all bodies.
FlowVector disturbed(const SlidingFlow& flow, const SlowMode& mode, DisturbanceKind kind, double size);
FlowVector disturbed(const ChainFlow& flow, const SlowMode& mode, DisturbanceKind kind, double size);

/// An impulse [N·s] on the link; y is not finite where a law that needs motion is pushed to rest.
void push(const SlidingFlow& flow, FlowVector& y, double impulse);
void push(const ChainFlow& flow, FlowVector& y, double impulse);

}  // namespace stickslip
