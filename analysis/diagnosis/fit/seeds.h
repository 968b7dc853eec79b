// Where a fit starts: seeds of the catalogue, and frequencies found on a grid.
#pragma once
#include "analysis/diagnosis/fit/problem.h"

#include <vector>

namespace stickslip::gap {

/// Peaks of the residual force's spectrum over time or over position, strongest first, at most `count`, in rad/s or
/// per unit of position. The residual force is what the problem's observer has to correct with where its candidate has
/// these parameters.
std::vector<double> grid_peaks(const FitProblem& problem, const std::vector<double>& si, FrequencyGrid grid,
                               std::size_t count);

/// Starting points of a single effect in the fit's own units. Combs are evaluated on the residual of `base` at `si`.
std::vector<Eigen::VectorXd> starts(const std::vector<Case>& cases, const Scales& scales, const Candidate& single,
                                    const Candidate& base, const std::vector<double>& si);

}  // namespace stickslip::gap
