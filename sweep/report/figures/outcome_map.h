// Measured outcomes on a chart of velocity and stiffness, with the boundaries of friction laws. Internal to
// sweep/report.
#pragma once
#include "analysis/diagnosis/outcomes/explain.h"
#include "analysis/results/report.h"

namespace stickslip {

/// The rows with one k_v on a chart of velocity and stiffness, with the boundary of every law that is in the running.
Figure outcome_map(const gap::OutcomeAnswer& answer, const Joint& nominal, double k_v, int number);

}  // namespace stickslip
