// Neighbours whose own mode lies near the frequency at which friction turns this joint unstable.
#pragma once
#include <vector>

#include "analysis/joint/joint.h"
#include "analysis/results/point.h"

namespace stickslip {

/// A neighbour that neither a rigid nor a free one bounds: its mode is close to the joint's own frequency.
struct NearMode {
    int neighbour = 0;         ///< index in the joint's list
    double omega = missing;    ///< of the neighbour's mode, √(k_p/inertia)
    double friction = missing; ///< of the joint without neighbours, at its critical gain
};

inline constexpr double near_mode = 0.3;  ///< share of the frequency within which the coupling decides

std::vector<NearMode> near_modes(const Joint& joint);

}  // namespace stickslip
