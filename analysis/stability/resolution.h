// How slow a joint can go: stable velocities for given gains, and what a whole range of velocities asks of k_v.
#pragma once
#include <vector>

#include "analysis/joint/joint.h"
#include "analysis/stability/verdict.h"

namespace stickslip {

/// Which theory judges.
enum class Theory { velocity_only, state_variable };

/// The velocities at which steady sliding is stable with the joint's own gains, within [low, high], both of one sign.
struct StableVelocities {
    std::vector<Interval> intervals;  ///< an end equal to low or high is that of the search
    double least = missing;      ///< resolution limit of §6: the slowest stable V_0 [m/s | rad/s]; NaN: none is stable
    double all_above = missing;  ///< all faster ones are stable: slower lies the first stick-slip
    double least_force_rate =
        missing;  ///< force control: `least` · (k_p + k_c), the stiffness of the contact [N/s | N·m/s]
};

/// A logarithmic scan of `scan` steps, each change located to 1e-10: two changes within one step can be missed.
StableVelocities stable_velocities(const Joint& joint, double low, double high, Theory theory, int scan = 200);

/// Armstrong's experiment (§5): the contact force ramps at `rate` through a spring, so that V_0 = rate/(k_p + k_c) and
/// a stiffer spring gives a smaller velocity. The k_p in [low, high] with which sliding is stable, by stable_gains; of
/// a real loop by a scan of its growth, as stable_velocities. Force control only: throws std::invalid_argument
/// otherwise.
std::vector<Interval> stable_springs(const Joint& joint, double rate, double low, double high, Theory theory);

/// The k_v, to be exceeded, that the velocity-only theory requires over a whole range of velocities, and the hardest of
/// them: the maximum of −f_ss'(V) (the paper, below (21), prints "minimum"); for the Stribeck curve of (22) that is
/// (26), at the velocity of (25).
struct RangeGain {
    double k_v, velocity;              ///< [N·s/m | N·m·s/rad], [m/s | rad/s]; k_v NaN: none serves every velocity
    std::vector<Interval> stable_k_v;  ///< that serve every velocity: one mass (k_v, ∞), several may have windows
};

/// For all V from rest to `highest`, which may be negative and must not be 0 (nothing is thrown; 0 gives no answer that
/// means anything): a logarithmic scan from highest/1e6 of `scan` steps, then
/// golden sections. Several bodies: at the joint's own k_p, the set that is common to all velocities of the scan.
RangeGain velocity_gain_for_range(const Joint& joint, double highest, int scan = 600);

}  // namespace stickslip
