// The joint under a disturbance in time, on a page and in numbers.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "analysis/stability/forced_response.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace stickslip {

/// The disturbance: d(t) by kind or by file, for how long.
struct AskedDisturbance {
    std::string kind;  ///< "impulse", "step", "sine", "noise", or a file of two columns, time and force
    double size = 1, omega = missing, duration = missing;
    std::uint64_t seed = 1;
};

/// The answer of the linear joint, link in excess of steady sliding.
struct DisturbedMotion {
    SampledForce force;
    ForcedResponse memory, velocity_only;
    double peak = missing, peak_time = missing;  ///< largest |x| with memory
};

inline constexpr int sampled_disturbance = 4000;  ///< samples of a force or a load over the time that is shown

/// Whether `kind` is none of the names.
bool is_force_file(const AskedDisturbance& asked);

/// Nothing where the linear theory has no response of the loop. Not set: a duration that shows the slowest mode or the
/// whole file, a sine at the peak of |X/D|. Throws BadInput for a file that cannot be read.
std::optional<DisturbedMotion> disturbed_motion(const Joint& joint, const AskedDisturbance& asked);

Figure disturbance_figure(const Joint& joint, const AskedDisturbance& asked, const DisturbedMotion& motion);

}  // namespace stickslip
