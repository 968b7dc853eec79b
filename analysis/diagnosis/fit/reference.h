// The reference that a controller must have followed, where it was not logged.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

namespace stickslip::gap {

/// k_p r + k_v ṙ is the logged command plus k_p y + k_v v of the same tick, and all of these are exact numbers of the
/// controller: the reference follows up to where it began, which is forgotten within k_v/k_p, or a tick. Between the
/// rows of a log of every second tick, and while the command was at `limit`, the sum is interpolated, but for jumps:
/// those stand in `jumps`, for settle_jumps(). Afterwards the case has a reference, so that its loop can be simulated.
/// False, and nothing changed, where the command was not logged, no position was controlled, the controller is more
/// than k_p and k_v (what an integral held is not known), or readings between rows are unknown.
bool rebuild_reference(Case& c, double limit);

}  // namespace stickslip::gap
