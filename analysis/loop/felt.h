// What a linear verdict leaves out and an ordinary motion notices all the same.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// What a unit of the controller's output is as an effort, nothing of the supply's sag counted.
double effort_per_command(const Joint& joint);

/// Whether a push by the position error adds to the slopes of the loop at V_0. Beside a jump there is no slope.
bool push_is_felt(const Joint& joint);

/// Whether the dither's own velocity is noticed beside V_0.
bool dither_is_felt(const Joint& joint);

/// Whether the velocity that the disturbance forces on the joint, as one mass on the spring and damper of its loop, is
/// noticed beside V_0. Friction is left out, which may damp the motion or feed it: a resonance is always noticed.
bool disturbance_is_felt(const Joint& joint);

/// Whether a force of this slope per displacement is more than a hundredth of the loop's own stiffness.
bool noticed(const Joint& joint, double slope);

}  // namespace stickslip
