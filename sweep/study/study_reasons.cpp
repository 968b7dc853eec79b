#include "sweep/study/study_reasons.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip {

std::string_view name_of(StudyReason reason)
{
    constexpr std::array<std::string_view, 16> names{"no-stable-velocity",  "stable-at-lowest", "unstable-at-highest",
                                                     "kernel-at-one-speed", "no-single-k_v",    "not-stable",
                                                     "no-boundary-above",   "no-crossover",     "neutral",
                                                     "no-linear-response",  "no-period",        "no-pair-on-boundary",
                                                     "gains-not-alone",     "no-boundary",      "boundaries-differ",
                                                     "not-searched"};
    static_assert(names.size() == static_cast<std::size_t>(StudyReason::not_searched) + 1);
    return names[static_cast<std::size_t>(reason)];
}

std::vector<StudyReason> reasons_of(const StableVelocities& v, const Interval& searched)
{
    if (v.intervals.empty()) return {StudyReason::no_stable_velocity};
    std::vector<StudyReason> reasons;
    const double slowest = std::min(std::abs(searched.low), std::abs(searched.high));
    if (std::abs(v.least) <= slowest) reasons.push_back(StudyReason::stable_at_lowest);
    if (std::isnan(v.all_above)) reasons.push_back(StudyReason::unstable_at_highest);
    return reasons;
}

std::vector<StudyReason> reasons_of(const LoopMargins& m)
{
    if (std::isnan(m.gain_below)) return {StudyReason::not_stable};
    std::vector<StudyReason> reasons;
    if (std::isinf(m.gain_above)) reasons.push_back(StudyReason::no_boundary_above);
    if (std::isnan(m.crossover)) reasons.push_back(StudyReason::no_crossover);
    return reasons;
}

std::optional<StudyReason> response_reason(const LinearStudy& s)
{
    if (std::isinf(s.peak.magnitude)) return StudyReason::neutral;
    if (!std::isnan(s.peak.magnitude)) return {};
    return std::isnan(s.compliance) ? StudyReason::no_linear_response : StudyReason::not_stable;
}

std::optional<StudyReason> range_gain_reason(const LinearStudy& s)
{
    if (std::isnan(s.velocities.low)) return StudyReason::kernel_at_one_speed;
    if (s.range_gain && std::isnan(s.range_gain->k_v)) return StudyReason::no_single_k_v;
    return {};
}

std::optional<StudyReason> mix_reason(const LinearStudy& s)
{
    if (!std::isnan(s.mix.noise)) return {};
    if (std::isnan(s.velocity_noise)) return StudyReason::no_period;
    return s.mix_searched ? StudyReason::no_pair_on_boundary : StudyReason::not_searched;
}

std::optional<StudyReason> error_reason(const ReductionStudy& r)
{
    if (std::isfinite(r.own.error)) return {};
    return std::isnan(r.own.error) ? StudyReason::no_boundary : StudyReason::boundaries_differ;
}

}  // namespace stickslip
