// Loads over the position that change so slowly that the joint settles at every place: gravity at low velocity.
#pragma once
#include "analysis/simulation/attractor/nonlinear.h"

#include <optional>
#include <vector>

namespace stickslip {

/// A joint where its loads pull most, to either side, and where they change most with the position.
struct HeldLoad {
    std::vector<Joint> places;        ///< each with the load there as a constant one and a spring to the surroundings
    double repeats_after = infinity;  ///< s: the shortest wave that is held
};

/// Of loads that are too slow to be followed until they repeat. No places where there is none, or where one repeats
/// within a hundred swings of the joint on the spring of its gain.
HeldLoad held_where_load_is_slow(const Joint& joint);

/// The same of all loads over the position, however slow they are.
HeldLoad held_at_places(const Joint& joint);

/// The answer of the place with the worst motion, with what all of them say; none where a cycle is so slow that the
/// load changes on the way.
std::optional<NonlinearVerdict> worst_of(const std::vector<NonlinearVerdict>& places, double repeats_after);

/// Of a joint whose load is held, that answer; none where none is.
std::optional<NonlinearVerdict> slow_load_verdict(const Joint& joint, const NonlinearOptions& options);

}  // namespace stickslip
