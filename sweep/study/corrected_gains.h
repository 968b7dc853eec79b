// What a named cause means for the gains: both joints over their gains, how they move, and which gains would be right.
#pragma once
#include "analysis/base/parallel_for.h"
#include "analysis/design/design.h"
#include "analysis/results/trajectory.h"
#include "sweep/study/gain_chart.h"

#include <optional>
#include <string>

namespace stickslip {

/// Why no gains were looked for.
enum class NoGains {
    looked_for,
    force_control,  ///< the motor is a source of force, whose loop has no gains to choose
    dead_time,      ///< without ticks: each pair of gains costs a search for roots, and a page has no minutes for it
    interrupted,
    refused  ///< by design, which says why
};

/// The last third of a simulated motion.
struct SettledMotion {
    double low = missing, high = missing;  ///< velocity; NaN where there is no motion
    double rest_share = 0;                 ///< of its time
    Reason reason = Reason::none;          ///< why there is no motion
};
SettledMotion settled(const Trajectory& motion);

/// Of the documented joint and of the corrected one, at one velocity. Gains of charts and of the design are counted at
/// the joint, `per_drive` times those of the drive.
struct CorrectedGains {
    double velocity = missing;
    double per_drive = 1;
    double k_p = missing, k_v = missing;     ///< the joint's own
    std::optional<GainChart> before, after;  ///< over the same gains, with the joint's own
    Trajectory motion_before, motion_after;  ///< simulated, with the terms that no linear theory has
    SettledMotion settled_before, settled_after;
    DesignPoint at_right;             ///< on `after`, where there are right gains
    std::optional<GainDesign> right;  ///< least noise of the link, in the corrected joint
    Requirements required;
    bool noise_is_stated = false, rate_is_stated = false;
    NoGains none = NoGains::looked_for;
    std::string refusal;  ///< of design, where it refused
};

/// Nothing but the velocity where the data show no motion.
CorrectedGains corrected_gains(const Joint& before, const Joint& after, double velocity, const ParallelFor& parallel);

}  // namespace stickslip
