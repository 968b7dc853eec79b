// Random joints as their owners would describe them: no effect, plausible numbers.
#pragma once
#include "tests/blind/generate/machine.h"

#include <string>
#include <vector>

namespace blind {

class Draw;

/// A joint and the scales on which its numbers make sense.
struct Nominal {
    std::string family;
    Machine machine;
    double travel = 1, speed = 1;  ///< m or rad, and per second: what the excitations use
    double bandwidth = 20;         ///< rad/s, of the position loop
    double coulomb() const { return machine.mechanism.friction[0].coulomb + machine.mechanism.friction[1].coulomb; }
    double inertia() const { return machine.mechanism.inertia[0] + machine.mechanism.inertia[1]; }
    double viscous() const { return machine.mechanism.friction[0].viscous + machine.mechanism.friction[1].viscous; }
};

/// "revolute", "pendulum", "prismatic", "drive-volts" (effort source behind an amplifier), "dc-voltage", "dc-duty",
/// "two-mass" (any drive, mostly behind a reduction of 1 to 160), "stribeck".
const std::vector<std::string>& joint_families();
Nominal draw_nominal(const std::string& family, Draw& draw, const std::string& controller = "pd");

}  // namespace blind
