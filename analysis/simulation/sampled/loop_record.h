// A record of a joint along a reference, as its controller would have logged it.
#pragma once
#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"

namespace stickslip {

/// What the joint is commanded to do, row by row [reading units]; `velocity` and `feed_forward` may be empty:
/// the velocity is then that of the positions at the ticks (reference_rates).
struct ReferenceMotion {
    std::vector<double> time, position, velocity, feed_forward;  ///< [s], reading units, [N | N·m]
};

/// The columns of a record, one row a tick; of a continuous loop, one row a row of the reference.
struct LoopRecord {
    std::vector<double> time, reference_position, reference_velocity, position, velocity, effort_command,
        effort_measured, feed_forward;  ///< [s], reading units, the units of the drive's command, [N | N·m]
    Reason reason = Reason::none;       ///< why it is empty or ends early
    Detail why = Detail::none;          ///< the same more closely, where more is known
};

/// Starts at rest where the reference starts, or, under a law that cannot rest, sliding as the reference does. `seed` 0
/// gives a record without noise.
LoopRecord record_along(const Joint& joint, const ReferenceMotion& reference, std::uint64_t seed, double rtol = 1e-8);

}  // namespace stickslip
