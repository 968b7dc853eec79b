// The best pair of gains under requirements, as §5 of the paper asks for: position and velocity feedback weighed by the
// quality of their sensors.
#pragma once
#include "analysis/boundary/kinds/boundary.h"
#include "analysis/boundary/trace/coordinates.h"
#include "analysis/design/noise.h"
#include "analysis/results/design.h"
#include "analysis/stability/verdict.h"

#include <functional>

namespace stickslip {

/// Which noise the best gains make least: that of the link's motion, or that of the effort.
enum class DesignObjective { motion, effort };

/// What a pair of gains must meet, and what is made least among those that do.
struct Requirements {
    SensorNoise noise;                                    ///< that the gains let through
    DesignObjective objective = DesignObjective::motion;  ///< which noise is made least
    double stiffness_scale = infinity;  ///< the k_p that doubles the cost: cost = noise · (1 + k_p/stiffness_scale)
    double margin = 0.05;               ///< least distance to the nearest boundary, in ln of the uncertain parameters
    double least_velocity = not_set;    ///< sliding is to be stable at every velocity from here up to V_0
    double effort_limit = infinity;     ///< of the peak effort [N | N·m]
    double noise_multiple = 3;          ///< of the effort noise that counts towards the limit
    std::vector<Coordinate> uncertain;  ///< whose distance the margin is; empty: the friction's
    double k_p_low = not_set, k_p_high = not_set, k_v_low = 0, k_v_high = not_set;  ///< not set: see gain_range
    double front_points = 12;                                                       ///< points of the Pareto front
};

/// The requirements that the joint's description implies: noise and steps of its encoder, its sample time, filter and
/// limits. Without an encoder's noise and a period, neither noise nor sample time.
Requirements requirements_of(const Joint& joint);

/// Called at the start of each stage of a design, from the calling thread.
using DesignListener = std::function<void(DesignStage)>;

/// Minimises the cost over (k_p, k_v): NLopt's DIRECT-L over the whole range, then COBYLA under the constraints. The
/// front asks for each margin in turn. Velocity-only thinking solves the same problem with steady-state friction, and
/// is then judged with memory. Throws std::invalid_argument for requirements that mean nothing (no noise, no sample
/// time, empty ranges).
/// Real loops and delayed friction are searched by fewer gains (search_effort() multiplies them), each judged
/// along the directions that were found to be near.
GainDesign design_gains(const Joint& joint, const Requirements& requirements, const ParallelFor& parallel,
                        const DesignListener& listener = {});

/// The range of gains that is searched.
struct GainRange {
    Interval k_p, k_v;  ///< [N/m | N·m/rad], [N·s/m | N·m·s/rad]
};
/// The range of the requirements. Unset: k_p within three decades of the joint's own, k_v up to 30 times its damping.
GainRange gain_range(const Joint& joint, const Requirements& requirements);

/// The end of the search for the least stable velocity below the joint's own: a choice that reads so may be stable
/// below.
inline double lowest_velocity_searched(const Requirements& requirements, double velocity)
{
    constexpr double below_requirement = 0.1, below_velocity = 1e-4;  // parts down to which it is looked for
    return is_set(requirements.least_velocity) ? below_requirement * requirements.least_velocity
                                               : below_velocity * velocity;
}

}  // namespace stickslip
