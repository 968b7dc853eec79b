// Where a gap lies, drawn: the chain from the reference to the motion, and the regimes of the motion, with bars and
// whiskers.
#pragma once
#include "analysis/results/diagnosis.h"
#include "analysis/results/report.h"

namespace stickslip {

/// A box a stage of the chain, its share of the gap below it, and a bar a regime; whiskers are 95 % intervals. A stage
/// of which no signal was logged says so. Nothing is drawn of regimes where there are none.
Figure where_figure(const Diagnosis& d);

}  // namespace stickslip
