// The figures and numbers of the paper, computed anew: what `stickslip figures` writes.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/paper/paper_figures.h"

namespace stickslip {

/// Figs. 1a, 1b, 2 and 3.
Section friction_figures(const PaperFriction& friction);

/// §4 and §5: the regions of stability, (34), the root locus, and what both theories demand of Armstrong's joint.
Section stability_figures(const PaperStability& stability);

/// All of it as one page.
Report figures_report(const PaperAnswer& answer);

}  // namespace stickslip
