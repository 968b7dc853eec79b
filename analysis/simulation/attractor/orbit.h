// Closed orbits of several turns.
#pragma once
#include "analysis/simulation/attractor/cycle.h"

namespace stickslip {

struct Orbit {
    Cycle cycle;
    int turns = 1;  ///< after which it closes, and no sooner
};

/// Of the orbits that close after a divisor of `watched_turns`, or after twice as many, the shortest that attracts and
/// crosses the section within `reach` of `guess`, in units of the flow's scale. For flows that shooting may continue
/// through all their motion, so not for bodies that come to rest. Nothing where the `work`, of which there may be no
/// limit (null), is spent before.
std::optional<Orbit> attracting_orbit(const Flow& flow, const FlowVector& guess, int watched_turns, double rtol,
                                      double reach, Work* work);

}  // namespace stickslip
