// The outcome of a check as a small page: old and new boundaries on one chart each, and what failed.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/check/boundaries.h"

#include <vector>

namespace stickslip {

Report check_report(const Spec& spec, const std::vector<Deviation>& deviations, const std::string& command);

}  // namespace stickslip
