// The motion that would tell two rivals apart best.
#pragma once
#include "analysis/diagnosis/search/attribute.h"
#include "analysis/results/diagnosis.h"

namespace stickslip::gap {

/// Simulates both rivals along each of a small set of cheap motions (no farther, faster or harder than the record, see
/// safe_motion.h, and the joint as well) and returns the one that drives them apart most, measured in noise standard
/// deviations of position and effort.
NextExperiment design_experiment(const Case& like, const Scales& scales, const Attribution& winner,
                                 const Attribution& rival);

/// Names of a candidate's effects.
std::vector<std::string> names_of(const Candidate& candidate);
std::string joined(const std::vector<std::string>& names);

}  // namespace stickslip::gap
