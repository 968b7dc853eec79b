// The page of one simulated motion: time series, phase portrait, friction-velocity loop.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/results/report.h"
#include "analysis/results/trajectory.h"
#include "sweep/study/disturbed_motion.h"
#include "sweep/study/motion_curves.h"

#include <optional>

namespace stickslip {

/// What acted on the joint from outside, to be drawn beside the motion.
struct SimulatedSurroundings {
    std::optional<DisturbedMotion> linear;  ///< the force, and what the linear theory answers to it
    SampledLoad normal_load;
};

/// `verdict` is where the same disturbance ends without them; it stands beside the motion as a table.
Report trajectory_report(const Joint& joint, const Trajectory& trajectory, const NonlinearVerdict& verdict,
                         const SimulatedSurroundings& surroundings, const MotionCurves& curves);

}  // namespace stickslip
