// A reduction N between motor and joint. The mechanism of this generator lives on the joint's side; a log and a data
// sheet speak of the motor's: its encoder turns N times as far, its torque is the N-th part (by energy, inertia N²).
#pragma once
#include "tests/blind/generate/loop.h"

namespace blind {

/// The numbers that the motor's side of this machine has; link, load and transmission stay those of the joint.
Machine at_motor(const Machine& machine);

/// What the motor's side logs of it. A second encoder on the link stays as it is.
Record at_motor(Record record, const Machine& machine);

/// By how much a number of the joint file changes when the motor's side says it.
double motor_factor(const std::string& path, const Machine& machine);

}  // namespace blind
