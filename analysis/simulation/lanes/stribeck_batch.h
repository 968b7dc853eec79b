// From Stribeck joints to jobs of the lanes and back.
#pragma once
#include <optional>

#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/lanes/stribeck_job.h"

namespace stickslip::lanes {

/// A Stribeck joint in its natural units.
struct StribeckScaled {
    using Job = StribeckJob;
    using Answer = StribeckAnswer;
    StribeckGroups groups;
    double time;        ///< √(m/k_p) [s]
    double velocity;    ///< V_0
    double deflection;  ///< δ_ss
};

/// Groups of a joint that the lanes can follow: one mass, c4 = 1 or 2 and nothing beside the law, k_p > 0, damping that
/// an explicit method can step, V_0 up to 500^{1/c4} c3.
std::optional<StribeckScaled> stribeck_scaled(const Joint& joint);

bool less(const StribeckGroups& a, const StribeckGroups& b);

/// As for the slip law (batch.h).
StribeckJob job(const StribeckGroups& groups, bool search);
bool state(const Disturbance& disturbance, const Joint& joint, const StribeckScaled& scale, StribeckJob& job);

/// The fields of a row from an answer; false if the reference must decide.
bool write(const StribeckAnswer& answer, const StribeckScaled& scale, const StribeckJob& job, PointResult& point);

}  // namespace stickslip::lanes
