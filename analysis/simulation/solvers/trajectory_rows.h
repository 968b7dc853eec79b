// What a trajectory keeps of the instants of a motion: rows whose times rise.
#pragma once
#include "analysis/results/trajectory.h"
#include "analysis/simulation/flows/delayed_flow.h"
#include "analysis/simulation/solvers/motion.h"

namespace stickslip {

/// An instant has one row, the last that holds at it: a step shorter than what a double resolves of the time since the
/// start leaves none of its own. The time of a row that shall be t, with the last row dropped where that is not later.
double time_of_row(double t, Trajectory& path);

/// The row of an instant of a motion of this flow.
void keep_row(const SlidingFlow& flow, const Instant& now, Trajectory& path);
void keep_row(const ChainFlow& flow, const Instant& now, Trajectory& path);
void keep_row(const DelayedFlow& flow, const Instant& now, Trajectory& path);

}  // namespace stickslip
