// Which filter made the logged velocities v of the differences d of the readings, by least squares over all records of
// every tick, where no row that the filter remembers was lost. Internal to analysis/diagnosis/audit.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <vector>

namespace stickslip::gap {

/// v_k − v_{k−1} = g (d_k − v_{k−1}). The misfit is what it leaves over the rms of the velocity's steps.
struct OnePole {
    double gain = 0, misfit = 1;
};

OnePole one_pole_of(const std::vector<const Case*>& cases);

/// v_k − v_{k−1} = g (d_k − v_{k−1}) + a (v_{k−1} − v_{k−2}) + b (d_{k−1} − d_k) + c (d_{k−2} − d_k): any filter of two
/// poles and two zeros that passes a steady velocity.
struct TwoPoles {
    double gain = 0, misfit = 1;
    double delay = 0;  ///< ticks by which it follows a velocity that rises steadily
};

TwoPoles two_poles_of(const std::vector<const Case*>& cases);

}  // namespace stickslip::gap
