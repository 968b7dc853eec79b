// The first instants of sliding where the friction falls from its static value with a vertical tangent.
#pragma once
#include <optional>

#include "analysis/simulation/flows/flow.h"

namespace stickslip {

/// How a mass at rest gets to a speed.
struct BreakAway {
    double time;  ///< s
    double x;     ///< the spring's coordinate then
};

/// From y at V = 0, where the flow's branch says in which direction, to the signed velocity V. A Stribeck exponent
/// below one drops the friction like |V|^c4: the mass is thrown off, V ~ t^{1/(1−c4)}, and an implicit step across the
/// infinite slope lands on the wrong side of rest. With V^{1−c4} as the independent variable the same motion is smooth.
/// Nothing where the friction leaves rest otherwise: a solver starts there unaided. States other than x and V are held.
std::optional<BreakAway> break_away(const SlidingFlow& flow, const FlowVector& y, double V);

}  // namespace stickslip
