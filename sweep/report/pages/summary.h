// What a report draws from the results of a sweep: slices for its charts, counts, provenance.
#pragma once
#include "sweep/engine/plan.h"
#include "sweep/engine/results_file.h"
#include "sweep/report/pages/stability_report.h"
#include "sweep/study/spec.h"

namespace stickslip {

/// Fills [report] where the spec leaves it open: k_p against every other axis (or the first two axes), and k_cr(k_v,
/// V0) where both are axes.
void choose_charts(Spec& spec);

/// Reads the slices that the charts need through the grid point nearest to the design, and counts undecided rows.
SweepSummary summarise(const Spec& spec, const ResultsFile& results);

}  // namespace stickslip
