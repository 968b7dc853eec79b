// The loop of a joint that moves about its set point: dry friction then is a constant force, and what is left is
// linear.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// Whether the command answers later than the error and the velocity that it is made of: a sampled loop, dead time,
/// lag, a filtered velocity.
bool acts_late(const Joint& joint);

/// Growth rate of that linear loop as the joint has it [1/s], under this much viscous friction and the stiffness of
/// gravity, no limit reached. What is fed back against friction is left out: it is bounded. NaN where it is unknown.
double sliding_growth(const Joint& joint, double viscous);

/// The k_i up to which that loop is stable, from none on: in closed form by Routh where the loop does not act late; 0
/// where the least makes it unstable, and at most 100 times Routh's.
double stable_integral_gain(const Joint& joint, double viscous);

}  // namespace stickslip
