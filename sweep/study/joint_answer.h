// Everything that one joint is answered with: what `evaluate` prints and draws, and the design point of a sweep.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/boundary.h"
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/stability/verdict.h"
#include "sweep/study/linear_details.h"
#include "sweep/study/root_locus.h"

#include <optional>

namespace stickslip {

/// The velocities that slide smoothly with these gains, and where they were looked for.
struct VelocitySearch {
    double velocity = missing, low = missing, high = missing;
    StableVelocities found;
};

struct JointAnswer {
    LinearVerdict linear;
    NonlinearVerdict nonlinear;         ///< not_asked where it was not
    Region region = Region::undecided;  ///< both together
    bool slides = false;                ///< steady sliding exists; without it, all below is empty
    std::optional<NearestBoundary> nearest;
    std::optional<VelocitySearch> velocities;  ///< where the commanded velocity is set and not 0
    std::vector<Interval> ideal_gains;         ///< stable k_p of the paper's loop, where the joint has another
    LinearDetails details;
    std::optional<RootLocus> locus;
};

/// Root loci run over k_p from `lowest_gain` to `highest_gain`; not set: two decades to either side of the joint's own.
struct JointQuestion {
    double lowest_gain = missing, highest_gain = missing;
    bool locus = true;
};

/// The verdicts come from the caller, who may have printed them; `study` is linear_study(joint).
JointAnswer answer_joint(const Joint& joint, const LinearVerdict& linear, const NonlinearVerdict& nonlinear,
                         LinearStudy study, const JointQuestion& question = {});

}  // namespace stickslip
