// A run of the exported numbers as the engines of robot simulators take it.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "sweep/study/export/export.h"

#include <vector>

namespace stickslip {

/// At the rows of the record: where the measured body is, and what the servos ask for; at the joint's side of the gear.
struct SimulatorRun {
    std::vector<double> position, effort;
};

/// The servos follow the record's reference, which is divided by `scale` to stand at the joint's side. Each step of the
/// simulator takes the velocity first and the position with it (semi-implicit Euler), the damping of joints implicitly,
/// dry friction as an impulse of at most its level, and springs and servos from the step before, as MuJoCo's Euler
/// does; other engines' steps are of the same order. Isaac Lab's targets arrive late by the dead time. Loads, inertia
/// and switched drives of the record act.
SimulatorRun run_in_simulator(const ExportAnswer& answer, const Record& record, double scale);

}  // namespace stickslip
