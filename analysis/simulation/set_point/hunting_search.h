// The cycle of stops and slips where it has no closed form: the fixed point of the map from stop to stop.
#pragma once
#include "analysis/results/set_point.h"
#include "analysis/simulation/set_point/stops.h"

namespace stickslip {

/// Looks for starts a whose slip ends at +a, over the distances at which the integrator can break away, eight a decade;
/// a pair of cycles closer than that is missed. `natural` is a distance of the order of the slips.
SetPoint hunting_by_events(const StopToStop& motion, double natural, double dead_zone);

}  // namespace stickslip
