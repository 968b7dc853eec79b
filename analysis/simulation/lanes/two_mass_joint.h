// Joints of two masses in dimensionless groups and back.
#pragma once
#include <array>
#include <optional>

#include "analysis/simulation/lanes/watched_batch.h"

namespace stickslip::lanes {

/// Groups of a joint of two masses that the lanes can follow: a linear spring between them, the slip or the ageing law
/// with one state on either mass or on both, on the other one viscous friction or none.
std::optional<WatchedScaled> two_masses(const Joint& joint);

/// A joint of these groups whose units are those of its law.
Joint two_mass_joint(const WatchedGroups& groups);

/// Which component of a ChainFlow each unknown is.
std::array<int, most_unknowns> places_in_chain(const WatchedGroups& groups);

}  // namespace stickslip::lanes
