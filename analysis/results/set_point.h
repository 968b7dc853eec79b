// What a loop with integral action does when it is to stand still: plain data.
#pragma once
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/results/point.h"

namespace stickslip {

enum class Hunting : std::uint8_t { no, yes, undecided };

/// Why a set point is kept, hunted about, or not judged.
enum class SetPointReason : std::uint8_t {
    none,
    static_above_coulomb,  ///< hunts: every stable loop does where F_s > F_c
    falling_friction,      ///< hunts: friction falls far enough with speed
    no_integral_action,    ///< rests somewhere within the static friction's band
    static_is_coulomb,     ///< settles: F_s = F_c
    slips_shrink,          ///< settles: each slip ends nearer to the set point than the last
    held,                  ///< rests: limits keep the controller from breaking the static friction
    dead_zone,             ///< rests: slips end within the dead zone
    push_breaks_friction,  ///< hunts: the compensation alone moves the mass off any place but one
    driven_by_velocity,    ///< hunts: a compensation that follows the velocity gives more than friction takes
    not_driven,            ///< rests: it gives less, and each slip ends nearer to the set point
    dither_narrows,        ///< rests: a dither below the kinetic friction leaves less of the static one to hold it
    loop_unstable,         ///< while it moves, the loop as it is is unstable: from far enough away it diverges
    load_beyond_limits,    ///< the load exceeds what the limits leave by more than static friction: it falls away
    driven_cycle,          ///< hunts: the loop as it is keeps the joint moving
    force_control,         ///< the following are not judged
    several_bodies,
    law_needs_motion,
    law_without_motion,    ///< creep, delayed or linear laws: no simulation at rest
    dithered,              ///< a dither beside an integral or a push, or above the kinetic friction
    bristles_compensated,  ///< a compensation that is fed back, over friction without true rest
    friction_term,         ///< a term beside the law
    loop_not_simulated,    ///< sampled, late or filtered over bristles
    left_out,              ///< a term that this answer has no place for matters to it
    loaded,                ///< a constant load takes a part of a limit, and the answer depends on it
    not_converged
};

/// As JSON calls it.
constexpr std::string_view name_of(SetPointReason reason)
{
    constexpr std::string_view names[] = {"none",
                                          "static-above-coulomb",
                                          "falling-friction",
                                          "no-integral-action",
                                          "static-is-coulomb",
                                          "slips-shrink",
                                          "held",
                                          "dead-zone",
                                          "push-breaks-friction",
                                          "driven-by-velocity",
                                          "not-driven",
                                          "dither-narrows",
                                          "loop-unstable",
                                          "load-beyond-limits",
                                          "driven-cycle",
                                          "force-control",
                                          "several-bodies",
                                          "law-needs-motion",
                                          "law-without-motion",
                                          "dithered",
                                          "bristles-compensated",
                                          "friction-term",
                                          "loop-not-simulated",
                                          "left-out",
                                          "loaded",
                                          "not-converged"};
    static_assert(std::size(names) == static_cast<std::size_t>(SetPointReason::not_converged) + 1);
    return names[static_cast<std::size_t>(reason)];
}

enum class SetPointMethod : std::uint8_t { none, closed_form, event_driven, presliding, simulated };

/// As JSON calls it.
constexpr std::string_view name_of(SetPointMethod method)
{
    constexpr std::string_view names[] = {"none", "closed-form", "event-driven", "presliding", "simulated"};
    return names[static_cast<int>(method)];
}

/// What a slip from a distance from the set point, and those after it, end in.
enum class StartEnd : std::uint8_t { rests, hunts, diverges, undecided };

/// As JSON calls it.
constexpr std::string_view name_of(StartEnd end)
{
    constexpr std::string_view names[] = {"rests", "hunts", "diverges", "undecided"};
    return names[static_cast<int>(end)];
}

/// Neighbouring starts with one end, from the nearest to the furthest that was followed.
struct StartRange {
    double from = missing, to = missing;
    StartEnd end = StartEnd::undecided;
};

struct SetPoint {
    Hunting hunting = Hunting::undecided;
    SetPointReason reason = SetPointReason::none;
    SetPointMethod method = SetPointMethod::none;
    double amplitude = missing;   ///< distance of the stops from the set point
    double slip_time = missing;   ///< of one slip
    double stick_time = missing;  ///< of one stop
    double period = missing;      ///< two of each
    double multiplier = missing;  ///< by which a small change of the amplitude changes from stop to stop
    double rest_error = missing;  ///< largest distance at which the mass may rest for ever; 0: it settles
    double searched_from = missing, searched_to = missing;  ///< starts of slips that were followed, by size
    int starts = 0;                                         ///< how many; 0: none, in closed form
    double largest_ratio = missing;  ///< of the distance after such a slip to that before: below 1 all of them shrink
    double own_level = missing;      ///< the static friction, in effort: what a compensation may not reach
    double compensation = missing;   ///< level of what was added against friction, in effort; missing: nothing
    bool asymmetric = false;         ///< hunts, but with stops at unequal distances: `amplitude` is the largest
    bool rests_nearby = false;       ///< hunts from further away, rests from nearby
    std::vector<StartRange>
        by_start;  ///< outwards, where starts were followed to their ends; between them it may differ
    std::vector<std::string> not_used;  ///< keys of the joint that this answer leaves out

    /// Up to where every start comes to rest; missing: not from nearby, or not followed.
    double rests_within() const
    {
        return !by_start.empty() && by_start.front().end == StartEnd::rests ? by_start.front().to : missing;
    }
    /// The nearest start that was seen to diverge.
    double diverges_from() const
    {
        for (const auto& range : by_start)
            if (range.end == StartEnd::diverges) return range.from;
        return missing;
    }

    /// Leaves the set point, at least from far enough away, instead of resting or hunting about it.
    bool diverges() const
    {
        return reason == SetPointReason::loop_unstable || reason == SetPointReason::load_beyond_limits;
    }
};

}  // namespace stickslip
