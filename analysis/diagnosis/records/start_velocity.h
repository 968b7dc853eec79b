// How fast a joint moves where its record begins.
#pragma once
#include "analysis/diagnosis/records/ticks.h"

namespace stickslip::gap {

struct StartVelocity {
    double value = 0;         ///< m/s | rad/s, of the reading
    double error = 0;         ///< its standard error, from the noise of the readings
    double acceleration = 0;  ///< m/s² | rad/s²
};

/// At the first row, from the readings behind it. A line through a few of them would be their mean velocity, which in a
/// joint that accelerates is another, and a line through many would be off by more: a cubic over as many rows as agree
/// with those of shorter ones (Lepskii 1991, Theory Probab. Appl. 35, 454-466).
StartVelocity velocity_at_start(const Ticks& ticks);

/// Lets a record begin in motion.
void start_moving(Ticks& ticks);

}  // namespace stickslip::gap
