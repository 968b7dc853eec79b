// What the page of a set point's design shows beside its answer: what other choices would do.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/design/set_point_design.h"
#include "analysis/simulation/sampled/loop_record.h"

#include <vector>

namespace stickslip {

/// A joint that is let go beside its set point.
struct ReleasedMotion {
    std::vector<double> time, error;
};

struct SetPointScan {
    /// A push towards the set point beside the integral, as effort, and how far away the joint then stops (0: it
    /// settles; NaN: not judged), with the friction as described.
    std::vector<double> push, amplitude;
    /// Shares by which friction may be off, and the design for each: all ways but those with a dead zone.
    std::vector<double> margins;
    std::vector<SetPointDesign> designs;
    /// The joint with the integral that the ways have, and with the best of them.
    ReleasedMotion before, after;
};

SetPointScan set_point_scan(const Joint& joint, const SetPointRequirements& asked, const SetPointDesign& design,
                            const ParallelFor& parallel);

}  // namespace stickslip
