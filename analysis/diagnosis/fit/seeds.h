// Where a fit starts: seeds of the catalogue, and frequencies found on a grid.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <vector>

namespace stickslip::gap {

/// Peaks of the residual force's spectrum over time or over position, strongest first, at most `count`, in rad/s or
/// per unit of position. The residual force is what an observer of this bandwidth has to correct with.
std::vector<double> grid_peaks(const std::vector<Case>& cases, const Scales& scales, const Candidate& base,
                               const std::vector<double>& si, FrequencyGrid grid, double omega, std::size_t count);

/// Starting points of a single effect in the fit's own units. Combs are evaluated on the residual of `base` at `si`.
std::vector<Eigen::VectorXd> starts(const std::vector<Case>& cases, const Scales& scales, const Candidate& single,
                                    const Candidate& base, const std::vector<double>& si);

}  // namespace stickslip::gap
