// Everything beyond the verdict that the linear theory can say of one joint: what evaluate prints and reports draw.
#pragma once
#include <optional>

#include "analysis/stability/comparison.h"
#include "analysis/stability/loop_margins.h"
#include "analysis/stability/reduction_study.h"
#include "analysis/stability/resolution.h"

namespace stickslip {

/// Armstrong's ramps at the joint's own rate of force.
struct ForceRamp {
    double rate = missing;                                ///< of the force: (k_p + k_c) V_0 [N/s | N·m/s]
    std::vector<Interval> velocity_only, state_variable;  ///< stable k_p at that rate [N/m | N·m/rad]
};

/// Margins, velocity windows, reductions and noise of one joint.
struct LinearStudy {
    double compliance = missing;          ///< |X/D|(0): lasting displacement per lasting force on the link
    ResponsePeak peak{missing, missing};  ///< largest displacement per periodic force
    LoopMargins margins{missing, missing, missing, missing};  ///< of the loop opened at its command
    Interval velocities{missing, missing};           ///< searched for stable_velocities; NaN: known_at_one_velocity
    StableVelocities velocity_only, state_variable;  ///< by either theory [m/s | rad/s]
    int velocities_looked_at = 0;         ///< by stable_velocities: two changes between neighbours are not seen
    std::optional<RangeGain> range_gain;  ///< k_v for every velocity up to the highest searched
    Comparison comparison;                ///< stable gains by either theory
    double velocity_noise = missing;  ///< σ_v/σ_x = √2/T of a differenced position, where the loop has a sample time
    GainMix mix;                      ///< for velocity_noise
    bool mix_searched = true;         ///< false: takes more than the usual effort
    std::optional<ForceRamp> ramp;    ///< force control
    std::vector<ReductionStudy> reductions;  ///< smaller models, and how far their boundaries are off
};

/// Whether the joint's sampled loop is judged by its characteristic function, because of many dead ticks or of delayed
/// friction: each of its roots then costs a search.
bool many_dead_ticks(const Joint& joint);

/// Whether a friction of the joint is a kernel: found at one velocity, it says nothing about others.
bool known_at_one_velocity(const Joint& joint);

/// How far velocities and springs are searched to either side of the joint's own.
inline constexpr double study_decades = 3;

/// The study at the joint's commanded velocity. Without steady sliding all is missing.
LinearStudy linear_study(const Joint& joint);

}  // namespace stickslip
