// The cycle of stops and slips where it has no closed form: the fixed point of the map from stop to stop.
#pragma once
#include "analysis/results/set_point.h"
#include "analysis/simulation/set_point/start_search.h"
#include "analysis/simulation/set_point/stops.h"

namespace stickslip {

/// Looks for starts a whose slip ends at +a, over the distances at which the integrator can break away, so many a
/// decade; a pair of cycles closer than that is missed. `natural` is a distance of the order of the slips.
SetPoint hunting_by_events(const StopToStop& motion, double natural, double dead_zone, const StartSearch& search);

/// The same of a loop that does not integrate, under a compensation that follows the velocity: slips follow from one
/// another without a stop to wind up, and a cycle is what far starts end in.
SetPoint hunting_without_integral(const StopToStop& motion, double band);

}  // namespace stickslip
