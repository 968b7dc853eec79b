// What an engineer reads off a motion along a reference: overshoot, settling time, the stairs of slow motion.
#pragma once
#include <span>

#include "analysis/results/point.h"

namespace stickslip {

struct MotionMeasures {
    double travel = missing;     ///< of the reference, from its first row to its last
    double overshoot = missing;  ///< largest excess over the last reference, in the direction of travel; ≥ 0
    double settling_time =
        missing;  ///< after the reference stops: until the error stays within `settled_share` of travel
    double final_error = missing;   ///< reference minus position in the last row
    int stairs = 0;                 ///< stops while the reference moves on in one direction
    double stair_height = missing;  ///< mean distance from stop to stop
    double stair_rate = missing;    ///< stairs a second
};

inline constexpr double settled_share = 0.02;
/// A stop begins below this share of the reference's speed and ends above the next.
inline constexpr double stop_share = 0.1, go_share = 0.5;

/// Of rows of equal number; what the motion does not show is NaN: overshoot and settling need a reference that comes to
/// rest after a travel, stairs need two stops. `reading_error`: how far a position may be off, by an encoder's step or
/// its noise; stairs are counted over moves that are large beside it.
MotionMeasures measure_motion(std::span<const double> time, std::span<const double> reference,
                              std::span<const double> position, double reading_error = 0);

/// Of a motion in what an encoder reads, `scale` per displacement: the lengths as displacements of the joint.
MotionMeasures per_reading(MotionMeasures measures, double scale);

}  // namespace stickslip
