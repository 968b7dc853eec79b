// The numbers of a candidate within their ranges. Internal to analysis/diagnosis/fit.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

namespace stickslip::gap {

/// Each number no further than its range.
Eigen::VectorXd bounded(const Candidate& c, Eigen::VectorXd x);

}  // namespace stickslip::gap
