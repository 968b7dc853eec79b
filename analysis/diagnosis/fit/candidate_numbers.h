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

/// How many numbers more than another set of causes this one has.
double parameters_more(const Candidate& c, const Candidate& than);

/// Whether a rival, some of its numbers at nothing, makes the very motion of the cause in whose place it stands.
bool makes_the_motion_of(const Candidate& one, const Candidate& rival);
/// The same either way.
bool move_alike(const Candidate& one, const Candidate& other);

}  // namespace stickslip::gap
