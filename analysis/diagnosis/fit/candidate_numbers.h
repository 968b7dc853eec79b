// The numbers of a candidate: within their ranges, around their priors, each record's own.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <optional>

namespace stickslip::gap {

/// Each number no further than its range.
Eigen::VectorXd bounded(const Candidate& c, Eigen::VectorXd x);

/// Around what the prior of a number lies, as fitted: the seed of a correction that has one, otherwise "as documented".
double prior_mean(const Candidate& c, std::size_t parameter);
/// Whose value a number is: that of the record of this number, or of none where all share it.
std::optional<std::size_t> record_of(const Candidate& c, std::size_t parameter);

}  // namespace stickslip::gap
