// What a law's numbers cost against the rows of a table of outcomes, and what that tells of their errors. Internal to
// analysis/diagnosis/outcomes.
#pragma once
#include "analysis/diagnosis/outcomes/law_fit.h"
#include "analysis/diagnosis/outcomes/rivals.h"

namespace stickslip::gap {

double log_probability(double p, bool stick_slip);

std::vector<double> distances(const Outcomes& o, const FrictionLaw& law, const std::vector<std::size_t>& rows);

std::vector<std::size_t> all_rows(const Outcomes& o);

/// −log posterior: rows, and a wide Gaussian around usual numbers that keeps undetermined ones in place.
double cost(const Outcomes& o, const RivalLaw& rival, const std::vector<std::size_t>& rows,
            const std::vector<double>& x);

/// Standard errors of the SI values from the curvature of the cost; a flat direction gets what the prior leaves.
std::vector<double> standard_errors(const Outcomes& o, const RivalLaw& rival, const std::vector<double>& x);

void judge(const Outcomes& o, LawFit& fit);

}  // namespace stickslip::gap
