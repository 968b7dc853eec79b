// The push against dry friction at a set point, in units of effort.
#pragma once
#include "analysis/joint/feed_forward.h"

namespace stickslip {

/// FeedForward::push of a controller whose reference stands still. The simulation from stop to stop needs its slopes,
/// and takes the side of a jump from the motion.
struct Compensation {
    CoulombFrom from = CoulombFrom::reference;
    double level = 0;
    double speed = 1e-3, width = 0;

    bool by_velocity() const { return from == CoulombFrom::velocity && level != 0; }
    bool by_error() const { return from == CoulombFrom::error && level != 0; }
    bool acts() const { return by_velocity() || by_error(); }
    /// The whole level on one side of the set point, its opposite on the other.
    bool jumps() const { return by_error() && width == 0; }
};

}  // namespace stickslip
