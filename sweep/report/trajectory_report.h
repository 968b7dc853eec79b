// The page of one simulated motion: time series, phase portrait, friction-velocity loop.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "analysis/results/trajectory.h"
#include "analysis/simulation/nonlinear.h"

namespace stickslip {

/// `verdict` is where the same disturbance ends; it stands beside the motion as a table.
Report trajectory_report(const Joint& joint, const Trajectory& trajectory, const NonlinearVerdict& verdict);

}  // namespace stickslip
