// What verdicts about ideal and about real loops are put together from. Internal to analysis/stability.
#pragma once
#include "analysis/stability/stable_gains.h"
#include "analysis/stability/verdict.h"

#include <cmath>
#include <utility>

namespace stickslip {

/// The stable gains and all that hangs on them.
inline void take_gains(StateVariableVerdict& memory, StableGains gains)
{
    memory.crossings = std::move(gains.crossings);
    memory.stable_intervals = std::move(gains.stable);
    memory.doubtful = std::move(gains.doubtful);
    memory.searched_from = gains.searched_from;
    memory.searched_to = gains.searched_to;
    memory.k_cr = gains.k_cr;
}

/// Stable by it or not; false, with the reason, where it is not finite.
inline bool take_abscissa(LinearVerdict& verdict, double spectral_abscissa)
{
    auto& memory = verdict.state_variable;
    memory.spectral_abscissa = spectral_abscissa;
    if (!std::isfinite(spectral_abscissa)) {
        verdict.steady.reason = Reason::not_finite;
        return false;
    }
    memory.stable = spectral_abscissa < 0;
    memory.neutral = spectral_abscissa == 0;
    return true;
}

}  // namespace stickslip
