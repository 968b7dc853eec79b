// Measured outcomes on a chart of velocity and stiffness, with the boundaries of friction laws. Internal to
// sweep/report.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/outcome_answer.h"

namespace stickslip {

/// The rows with one k_v on a chart of velocity and stiffness, with the boundaries of the best laws of either kind.
Figure outcome_map(const gap::OutcomeAnswer& answer, const OutcomeMap& map, std::size_t number);

}  // namespace stickslip
