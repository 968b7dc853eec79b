// What pulls on a joint at its set point, which is where its encoder reads 0.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// Signed, in effort on the mechanism, positive where it pulls in the direction of positive motion.
struct RestingPull {
    double on_limits = 0;    ///< what the actuator has to hold
    double on_feedback = 0;  ///< the same less the gravity that the controller feeds forward
};

/// At a distance x from the set point: constant load, gravity and cogging there, and half of what friction differs
/// between the two directions. `per_signal`: effort per command.
RestingPull pull_at(const Joint& joint, double x, double per_signal);

/// Stiffness that gravity adds about the set point, negative where it topples.
double gravity_stiffness(const Joint& joint);

/// Whether the load changes with position by enough to be noticed beside the loop's own stiffness.
bool load_bends(const Joint& joint);

}  // namespace stickslip
