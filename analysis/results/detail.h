// What is known of a motion beyond the Reason of its verdict: codes; the words for them stand where words are.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace stickslip {

enum class Detail : std::uint8_t {
    none,
    // no motion is followed about steady sliding
    late_with_memory,    ///< delayed friction, with memory on top of it
    moving_normal_load,  ///< part of the linear theory only
    neighbours,          ///< likewise
    backlash,            ///< leaves no steady sliding to disturb
    place_or_time,       ///< a force or friction changes with position or time, and does not repeat soon enough
    chatters,            ///< a push towards the set point jumps by more than steady sliding takes
    effort_limit,        ///< is below what steady sliding takes
    no_time_step,        ///< that the simulation can take, beside the fastest rate of the joint
    // no equations of motion in a real loop
    force_loop,           ///< is simulated without sampling and dead time only
    normal_load_in_loop,  ///< one that moves with the joint
    neighbours_in_loop,
    linear_law,
    bristles_with_memory,
    no_level,  ///< a law without a level that place, time or load could change
    // a motion that was followed
    limit_of_turns,
    limit_of_work,        ///< of one verdict; a higher effort may be requested
    larger_not_followed,  ///< a larger disturbance, to its end
    stopped,              ///< it could not be followed any further
    // no growth rate
    growth_unmeasured,   ///< too small beside its frequency
    growth_unresolved,   ///< a motion grows otherwise than the spectrum says
    not_followed,        ///< no motion was
    dead_time_too_long,  ///< for the multipliers of the simulated loop
    leaves_within_tick,  ///< steady sliding
    // no fold
    branch_lost,         ///< of limit cycles
    branch_not_smooth,   ///< folds are followed for cycles of one body with memory that never rests
    fold_of_ideal_loop,  ///< only there folds are followed
    // no record along a reference
    few_rows,     ///< a reference needs two
    uneven_rows,  ///< of the reference of a continuous loop
    too_many_ticks,
    law_at_rest,  ///< has no meaning there
    // no disturbance of this kind
    no_state,       ///< the friction on the link has none that could be disturbed
    forces_in_loop  ///< forces and loads from outside act on the ideal loop only
};

inline constexpr std::array<std::string_view, 33> detail_names{"none",
                                                               "late-with-memory",
                                                               "moving-normal-load",
                                                               "neighbours",
                                                               "backlash",
                                                               "place-or-time",
                                                               "chatters",
                                                               "effort-limit",
                                                               "no-time-step",
                                                               "force-loop",
                                                               "normal-load-in-loop",
                                                               "neighbours-in-loop",
                                                               "linear-law",
                                                               "bristles-with-memory",
                                                               "no-level",
                                                               "limit-of-turns",
                                                               "limit-of-work",
                                                               "larger-not-followed",
                                                               "stopped",
                                                               "growth-unmeasured",
                                                               "growth-unresolved",
                                                               "not-followed",
                                                               "dead-time-too-long",
                                                               "leaves-within-tick",
                                                               "branch-lost",
                                                               "branch-not-smooth",
                                                               "fold-of-ideal-loop",
                                                               "few-rows",
                                                               "uneven-rows",
                                                               "too-many-ticks",
                                                               "law-at-rest",
                                                               "no-state",
                                                               "forces-in-loop"};
static_assert(detail_names.size() == static_cast<std::size_t>(Detail::forces_in_loop) + 1);

/// As JSON calls it.
constexpr std::string_view name_of(Detail detail)
{
    return detail_names[static_cast<std::size_t>(detail)];
}

/// Larger disturbances that are tried where the stated one decays: always a start from near rest, and
enum class LargerTried : std::uint8_t {
    none,            ///< nothing was tried
    from_near_rest,  ///< no other
    pulls,           ///< pulls of the spring from either side, by 1.25 and 3 V_0/|s|
    swings,          ///< a large swing of every lightly damped mode
    pull,            ///< a pull of the spring by 3 V_0/|s|
    pull_of_spring   ///< by 3 V_0 √(m/k_p), where the slowest mode is that of the integral
};
inline constexpr std::array<std::string_view, 6> larger_tried_names{"none",   "near-rest", "pulls",
                                                                    "swings", "pull",      "pull-of-spring"};
constexpr std::string_view name_of(LargerTried tried)
{
    return larger_tried_names[static_cast<std::size_t>(tried)];
}

}  // namespace stickslip
