// At which side of a gear a loop's numbers stand. The paper's maps count displacement, velocity and gains at the joint;
// a drive reads and pushes its motor, and so do records of it.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// The reading per displacement of the joint: N where a geared motor carries the encoder, else 1.
double reading_per_joint(const Joint& joint);

/// The joint of a record, whose loop is counted at the encoder's side, with its loop counted at the joint's side: gains
/// and motor constants reflected, k N², F N, x/N. V_0 stays, it is the joint's. Unchanged without a gear.
Joint with_loop_at_joint(Joint joint);

}  // namespace stickslip
