// The gains that a logged command was made with, by regression on what they multiply.
#pragma once
#include "analysis/diagnosis/audit/regression.h"
#include "analysis/diagnosis/fit/fit.h"

#include <vector>

namespace stickslip::gap {

/// The rows that no limit touches, with this filter time constant: what the gains multiply, and the logged command.
GainRegression regression_of(const Case& c, double tau, double limit);

/// One gain pair a record: overrides may give every record its own documented gains.
std::vector<GainRegression::Answer> gains_of(const std::vector<Case>& cases, double tau, double limit);

/// RMS of the command's misfit over its RMS, the mean of the records.
double mean_misfit(const std::vector<GainRegression::Answer>& answers);

/// Golden-section search of the filter time constant with the least misfit, both gains free.
double best_tau(const std::vector<Case>& cases, double limit);

}  // namespace stickslip::gap
