// The charts of a diagnosis. Internal to sweep/report.
#pragma once
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

namespace stickslip {

/// Per record, of the first few: what the simulation gets wrong in position and in effort before and after, and for the
/// first one the measured signals themselves beside the simulated ones.
std::vector<Figure> trace_figures(const Diagnosis& d);

/// Position and effort of the first record, measured and simulated, which the page can play. Empty where the simulation
/// gets no position wrong.
std::vector<Figure> played_figures(const Diagnosis& d);

/// The motion to measure next.
Figure experiment_figure(const Diagnosis& d);

}  // namespace stickslip
