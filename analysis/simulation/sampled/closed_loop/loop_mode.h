// The slowest mode of a sampled loop about steady sliding, from the simulated motion itself.
#pragma once
#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"

#include <complex>

namespace stickslip {

/// The multiplier of largest magnitude of the map from tick to tick, taken by differences of simulated ticks, and its
/// eigenvectors over SampledLoop::state().
struct LoopMode {
    std::complex<double> multiplier{missing, missing};  ///< infinite where a tick lets the mode grow beyond all numbers
    std::complex<double> root{missing, missing};        ///< s, where the theory told it and not the multiplier [1/s]
    std::vector<std::complex<double>> left, right;
    std::vector<double> steady;
    double period = missing;    ///< of the loop
    Detail why = Detail::none;  ///< why there is none

    bool known() const { return std::isfinite(std::abs(multiplier)) || std::isfinite(std::abs(root)); }
    /// s of z = e^{sT}, in the upper half plane.
    std::complex<double> rate() const;
    /// Over which a growth is measured: one turn, or a factor of 3 if that comes first; whole ticks.
    long window() const;
};

/// The same from the linear theory, without vectors: the past of delayed friction is no state that could be
/// differenced, and what leaves steady sliding within a tick is no small motion at its end.
LoopMode mode_by_theory(std::complex<double> root, double period);

/// Whether a disturbance that is small at a tick has left the linear motion before the next.
bool leaves_within_tick(std::complex<double> root, double period);

/// `loop` must be under fixed steps and slide steadily.
LoopMode loop_mode(SampledLoop& loop);

/// The growth rate of a small disturbance along that mode, measured by following it on both sides and at two sizes;
/// NaN where the motion leaves steady sliding too soon.
double measure_loop_growth(SampledLoop& loop, const LoopMode& mode);

}  // namespace stickslip
