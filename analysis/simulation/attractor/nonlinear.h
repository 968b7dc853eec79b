// The nonlinear truth about one joint: what a disturbance ends in, and which outcomes coexist.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/disturbance.h"
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/results/point.h"

#include <string>

namespace stickslip {

/// What a nonlinear verdict looks for, and how closely.
struct NonlinearOptions {
    Disturbance disturbance;     ///< the one that the outcome means
    double rtol = 1e-8;          ///< relative tolerance of the solvers
    int turn_limit = 3000;       ///< revolutions after which a point is undecided
    bool region = true;          ///< also look for stick-slip that a larger disturbance reaches
    bool bifurcation = false;    ///< also criticality of the Hopf point and fold of limit cycles
    bool accelerate = true;      ///< shooting and amplitude jumps; off: the motion is watched until it repeats
    bool fallback_only = false;  ///< Rodas5P in place of CVODE
    double effort = 1;           ///< how much a verdict may compute, per the usual

    /// What is wrong with them; empty if nothing.
    std::string problem() const;
};

/// Integrates the joint through its disturbance and says where it ends. A joint that has no nonlinear answer gets its
/// reason (no velocity, linear_only, unsupported, …) and no exception; options with a problem() are a
/// std::invalid_argument. Safe to call from many threads. Of friction
/// that is delayed, stability and folds of the cycles are not computed.
NonlinearVerdict nonlinear_verdict(const Joint& joint, const NonlinearOptions& options);

/// Writes a verdict into the nonlinear fields of a row whose linear fields stand; a bistable joint changes its region.
void write_nonlinear(const NonlinearVerdict& verdict, PointResult& point);

}  // namespace stickslip
