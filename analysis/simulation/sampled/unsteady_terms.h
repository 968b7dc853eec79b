// What of a joint's forces changes on the way: with position, with time, or with the effort that the joint carries.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// Whether force or friction change with position, time or the effort carried: then only the loop's ticks follow it.
bool has_unsteady_terms(const Joint& joint);

/// Whether they change with position or time, so that no motion is steady.
bool changes_on_the_way(const Joint& joint);

/// The longest time after which such a change repeats at the commanded velocity, s: infinite for a drift of the
/// friction, 0 where nothing changes.
double longest_change(const Joint& joint);

/// The joint without them, whose sliding is steady.
Joint without_changes(Joint joint);

}  // namespace stickslip
