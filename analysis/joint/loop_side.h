// At which side of a gear a loop's numbers stand. The paper's maps count displacement, velocity and gains at the joint;
// a drive reads and pushes its motor, and so do records of it.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// Turns of the motor per turn of the joint; 1 where there is no gear.
double gear_ratio(const Joint& joint);

/// The reading per displacement of the joint: gear_ratio() where the motor carries the encoder, else 1.
double reading_per_joint(const Joint& joint);

/// The joint of a record, which reads at its encoder and pushes the motor, with its loop counted at the joint's side:
/// gains and motor constants reflected, k N² (k N of an encoder on the link), F N, x/N. V_0 stays, it is the joint's.
/// Unchanged without a gear.
Joint with_loop_at_joint(Joint joint);

}  // namespace stickslip
