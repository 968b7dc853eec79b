// What a table of measured outcomes was answered with, and the maps that its page draws.
#pragma once
#include "analysis/diagnosis/outcomes/explain.h"
#include "analysis/results/stability_map.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip {

/// A chart of velocity and stiffness at one velocity gain.
struct OutcomeMap {
    double k_v = 0;
    Axis x, y;                           ///< commanded velocity, position gain
    std::vector<double> sticks;          ///< by the best law, 1 where it sticks and slips, else 0; row-major
    Curve boundary;                      ///< of the best law
    const gap::LawFit* other = nullptr;  ///< the best law of the other kind, with memory or without; may be missing
    Curve other_boundary;
};

struct OutcomeMaps {
    std::vector<OutcomeMap> maps;  ///< those whose rows show most of the boundary
    std::size_t velocity_gains = 0;
};

/// `found` outlives the maps, and has laws.
OutcomeMaps outcome_maps(const gap::OutcomeAnswer& found, const Joint& nominal);

}  // namespace stickslip
