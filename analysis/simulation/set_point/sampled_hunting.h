// Hunting of a loop as it is: slips are followed tick by tick until they end, settle or repeat.
#pragma once
#include "analysis/results/set_point.h"
#include "analysis/simulation/set_point/sampled_stops.h"
#include "analysis/simulation/set_point/start_search.h"

namespace stickslip {

/// As hunting_by_events, of motions that begin on either side where the two differ. Stops of a sampled loop repeat to
/// within a tick only: the cycle is the mean of the last stops that were followed.
SetPoint hunting_by_simulation(const SampledStops& motion, double natural, const StartSearch& search);

/// The same of a loop that does not integrate: it rests where it is released within its band, and from further away
/// either comes to rest or goes on.
SetPoint resting_by_simulation(const SampledStops& motion);

}  // namespace stickslip
