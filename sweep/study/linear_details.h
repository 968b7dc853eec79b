// The curves behind the linear answer for one joint: what each theory demands over the velocity, the least velocity
// over the gains, the response to a disturbing force, and the springs that a ramp of force needs.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/stability/study.h"
#include "sweep/study/samples.h"

#include <array>
#include <optional>
#include <vector>

namespace stickslip {

/// The velocities that were searched, without their direction: for axes that are logarithmic.
inline Interval searched_speeds(const LinearStudy& study)
{
    const auto& v = study.velocities;
    return v.high < 0 ? Interval{-v.high, -v.low} : v;
}

/// V_min over k_p at one velocity gain: the speed from which on sliding is stable, with memory.
struct LeastVelocities {
    double k_v = missing;
    Samples over_k_p;
    double here = missing;  ///< at the joint's own k_p
};

/// Stable springs over the rate of force by one theory.
struct RampSprings {
    Samples above, below;        ///< stable above the one, below the other
    std::vector<Interval> here;  ///< at the joint's own rate
};

struct LinearDetails {
    LinearStudy study;
    double velocity = missing;                        ///< commanded
    bool sampled_finely = true;                       ///< false with delays and tables: the curves are coarser
    Samples demanded_memory, demanded_simple;         ///< least k_v over the velocity; simple: the velocity-only model
    std::vector<LeastVelocities> least_velocities;    ///< empty: known at one velocity only, or k_p < 0
    Samples response_memory, response_simple;         ///< |X/D| over ω
    double ramp_rate = missing;                       ///< of the joint's own spring; force control only
    std::optional<std::array<RampSprings, 2>> ramps;  ///< with memory, by the velocity-only model
};

/// The joint slides steadily unless study.compliance is NaN; then there are no curves.
LinearDetails linear_details(const Joint& joint, LinearStudy study);

}  // namespace stickslip
