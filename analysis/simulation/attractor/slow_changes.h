// Loads and friction that change so slowly, over the position or in time, that the joint settles at every place of the
// change: gravity at low velocity, a wave of the friction, a level that drifts.
#pragma once
#include "analysis/simulation/attractor/nonlinear.h"

#include <optional>
#include <vector>

namespace stickslip {

/// A joint at the places of what changes slowly: where a wave is highest, lowest and steepest, cold and warm.
struct HeldChanges {
    std::vector<Joint> places;        ///< each with what acts there held, its slope as a spring to the surroundings
    double repeats_after = infinity;  ///< s: the shortest wave that is held, or the time constant of a drift
};

/// Of changes that are too slow to be followed until they repeat. No places where there are none, or where one repeats
/// within a hundred swings of the joint on the spring of its gain.
HeldChanges held_where_changes_are_slow(const Joint& joint);

/// The answer of the place with the worst motion, with what all of them say; none where a cycle is so slow that what
/// is held changes on the way.
std::optional<NonlinearVerdict> worst_of(const std::vector<NonlinearVerdict>& places, double repeats_after);

/// Of a joint with slow changes that answer; none where it has none.
std::optional<NonlinearVerdict> slow_change_verdict(const Joint& joint, const NonlinearOptions& options);

}  // namespace stickslip
