// Which few changes of the controller's terms explain its command: all sets of a size, and dead zones. Internal to
// analysis/diagnosis/audit.
#pragma once
#include "analysis/diagnosis/audit/command_terms.h"

namespace stickslip::gap {

/// A dead zone and the linear changes beside it.
struct Changed {
    double dead_zone = 0;
    std::vector<int> terms;
    TermFit fit;
    std::size_t count(double documented) const { return terms.size() + (dead_zone != documented); }
};

/// The best set of at most `size` changes at this dead zone.
Changed best_set(const CommandTerms& all, double dead_zone, std::size_t size);

/// The dead zone that leaves least, with at most one other change.
Changed best_zone(const std::vector<Case>& cases, double limit, double largest_error);

}  // namespace stickslip::gap
