// Fits some parameters of a candidate while the others keep their values.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

namespace stickslip::gap {

/// One entry a parameter: 1 keeps its value. Empty: all are fitted.
using Kept = std::vector<char>;

/// descend() over the parameters that are not kept; the information of kept ones is zero.
LevelFit descend_block(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                       Eigen::VectorXd x, double omega, int iterations, const Kept& kept);

/// search_rough() over the parameters that are not kept.
LevelFit search_block(const std::vector<Case>& cases, const Candidate& candidate, const Scales& scales,
                      Eigen::VectorXd x, double omega, int evaluations, double first_step, const Kept& kept);

}  // namespace stickslip::gap
