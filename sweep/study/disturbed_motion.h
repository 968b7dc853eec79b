// What the linear theory answers to a force that acts on the link.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/stability/forced_response.h"
#include "sweep/study/time_series.h"

#include <cstdint>
#include <optional>
#include <string>

namespace stickslip {

/// The disturbance: d(t) by kind or as a record, for how long.
struct AskedDisturbance {
    std::string kind;  ///< "impulse", "step", "sine", "noise", or the file of the record
    double size = 1, omega = missing, duration = missing;
    std::uint64_t seed = 1;
    std::optional<TimeSeries> record;  ///< in the unit of the joint's efforts
};

/// The answer of the linear joint, link in excess of steady sliding.
struct DisturbedMotion {
    SampledForce force;
    ForcedResponse memory, velocity_only;
    double peak = missing, peak_time = missing;  ///< largest |x| with memory
};

inline constexpr int sampled_disturbance = 4000;  ///< samples of a force or a load over the time that is shown

/// Whether `kind` is none of the names.
inline bool is_force_file(const AskedDisturbance& asked)
{
    for (const char* name : {"", "impulse", "step", "sine", "noise"})
        if (asked.kind == name) return false;
    return true;
}

/// Nothing where the linear theory has no response of the loop. Not set: a duration that shows the slowest mode or the
/// whole record, a sine at the peak of |X/D|.
std::optional<DisturbedMotion> disturbed_motion(const Joint& joint, const AskedDisturbance& asked);

}  // namespace stickslip
