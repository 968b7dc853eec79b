// The page of one simulated motion: time series, phase portrait, friction-velocity loop.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "analysis/results/trajectory.h"

namespace stickslip {

Report trajectory_report(const Joint& joint, const Trajectory& trajectory);

}  // namespace stickslip
