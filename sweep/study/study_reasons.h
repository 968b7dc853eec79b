// Why numbers of the linear study are missing, or are no more than the ends of its search.
#pragma once
#include "analysis/stability/study.h"

#include <optional>
#include <string_view>
#include <vector>

namespace stickslip {

enum class StudyReason {
    no_stable_velocity,   ///< in the searched range, with these gains
    stable_at_lowest,     ///< the least stable velocity lies below the searched range
    unstable_at_highest,  ///< the highest velocity searched is not stable
    kernel_at_one_speed,  ///< friction found at one velocity says nothing about others
    no_single_k_v,        ///< serves every velocity of the range at this k_p
    not_stable,           ///< sliding is not: no margin to lose, no steady answer to a sine
    no_boundary_above,    ///< this k_p, as far as was searched
    no_crossover,         ///< |L| is 1 nowhere: no lag makes the joint unstable
    neutral,              ///< the answer to a sine grows without end
    no_linear_response,   ///< of this loop with this friction
    no_period,            ///< how noisy a differenced velocity is depends on control.period
    no_pair_on_boundary,  ///< of gains
    gains_not_alone,      ///< this loop has no independent gains k_p and k_v
    no_boundary,          ///< of either joint along the searched range: nothing to compare
    boundaries_differ,    ///< in number, of the full and the reduced joint
    not_searched          ///< within the usual effort
};

/// As JSON calls it.
std::string_view name_of(StudyReason reason);

std::vector<StudyReason> reasons_of(const StableVelocities& velocities, const Interval& searched);
std::vector<StudyReason> reasons_of(const LoopMargins& margins);
std::optional<StudyReason> response_reason(const LinearStudy& study);
std::optional<StudyReason> range_gain_reason(const LinearStudy& study);
std::optional<StudyReason> mix_reason(const LinearStudy& study);
std::optional<StudyReason> error_reason(const ReductionStudy& reduction);

}  // namespace stickslip
