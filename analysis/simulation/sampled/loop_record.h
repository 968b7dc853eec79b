// A record of a joint along a reference, as its controller would have logged it.
#pragma once
#include "analysis/simulation/sampled/closed_loop/sampled_loop.h"

namespace stickslip {

/// What the joint is commanded to do, row by row, as its controller has it: positions in what the encoder reads.
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
/// gives a record without noise; `rtol` is the relative tolerance of the solver. A joint that cannot be driven along
/// the reference gives an empty record with the reason (without control.period also where its rows are not even);
/// columns of the reference have equal lengths, which the caller checks. Throws nothing.
LoopRecord record_along(const Joint& joint, const ReferenceMotion& reference, std::uint64_t seed, double rtol = 1e-8);

}  // namespace stickslip
