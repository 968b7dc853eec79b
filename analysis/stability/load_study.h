// What the linear theory says of one joint over a range of normal loads, each held long enough for its verdict to mean
// something.
#pragma once
#include <span>
#include <vector>

#include "analysis/joint/joint.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// At one load: growth rates max Re s by both theories, critical gain with memory (NaN where there is none), least
/// velocity gain of the velocity-only model.
struct LoadedVerdict {
    double load, velocity_only, state_variable, k_cr, k_v_min;  ///< load as a ratio, 1/s twice, gains in SI
};

/// The verdicts over a range of loads, and what they come to over a record of loads.
struct LoadStudy {
    double low = missing, high = missing;  ///< loads, per the nominal one
    std::vector<LoadedVerdict> at;         ///< loads from low to high, evenly
    /// Shares of the record, within [0, 1], at whose load steady sliding is stable.
    double stable_velocity_only = missing, stable_state_variable = missing;
    /// The load that demands the largest k_cr, and that gain [N/m | N·m/rad]; NaN where none has one.
    double hardest_load = missing, hardest_k_cr = missing;
};

/// `loads`: samples of the normal load on the link's friction over equal times, per the one at which the numbers of its
/// law hold; all > 0 and finite, which the caller checks: nothing is thrown, and verdicts at a load ≤ 0 mean nothing.
/// Without loads the study is empty. Between the `levels` loads that are evaluated, growth rates are straight lines.
LoadStudy load_study(const Joint& joint, std::span<const double> loads, int levels = 101);

}  // namespace stickslip
