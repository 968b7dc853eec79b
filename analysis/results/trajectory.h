// A motion in time, for files, time series, phase portraits and friction-velocity loops.
#pragma once
#include "analysis/results/detail.h"
#include "analysis/results/point.h"

#include <vector>

namespace stickslip {

/// One motion, all vectors of one length. Velocity 0 with `stuck` set is true sticking.
struct Trajectory {
    std::vector<double> time;                 ///< s, rising from row to row
    std::vector<double> position;             ///< excess over the steady path [m | rad]
    std::vector<double> velocity;             ///< of the link [m/s | rad/s]
    std::vector<double> friction;             ///< effort on the link, against its motion [N | N·m]
    std::vector<std::vector<double>> states;  ///< of the friction law, one vector a state
    std::vector<std::uint8_t> stuck;          ///< 1: the link sticks
    double commanded_velocity = missing;      ///< V_0
    double steady_friction = missing;         ///< f_ss(V_0)
    Reason reason = Reason::none;             ///< why it is empty or stops early
    Detail why = Detail::none;                ///< the same more closely, where more is known
    bool used_fallback = false;               ///< CVODE gave up on the way and Rodas5P finished
};

/// The normal load of the link's friction in time, per the one at which the numbers of its law hold: `value[i]` holds
/// from i·step to (i + 1)·step, the last one for ever.
struct SampledLoad {
    double step = 0;            ///< s
    std::vector<double> value;  ///< ratios
};

}  // namespace stickslip
