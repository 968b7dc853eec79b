// Hunting where friction has no true rest: the bristles of LuGre and Dahl give way under the integrator.
#pragma once
#include "analysis/simulation/set_point/regulator.h"

namespace stickslip {

/// Where the motion from a distant start ends.
struct Presliding {
    enum class End { cycle, settles, runaway, failure };
    End end = End::failure;
    double amplitude = missing;   ///< largest distance from the set point
    double slip_time = missing;   ///< of a half period, faster than a hundredth of its highest speed
    double stick_time = missing;  ///< the rest of the half period
    double multiplier = missing;  ///< of successive amplitudes
};

/// Follows the motion from a stop at `start`, from crossing to crossing of the set point, until its amplitude repeats or
/// it no longer gets across. `effort` is the friction to be broken and `give` how far the bristles yield until then:
/// below it no stop is an obstacle.
Presliding follow_presliding(const Regulator& regulator, const Friction& friction, double start, double effort,
                             double give);

}  // namespace stickslip
