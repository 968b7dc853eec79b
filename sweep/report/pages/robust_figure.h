// The robustly stable set of gains on a chart.
#pragma once
#include "sweep/report/pages/margins_report.h"

namespace stickslip {

/// Three classes over two axes: stable in every joint of the uncertainty, stable as described only, unstable; with the
/// located edges between them and the design. Places take the side of the edges, not of a grid. `answer` has `robust`,
/// `nominal` and `worst`.
Figure robust_figure(const MarginsAnswer& answer);

}  // namespace stickslip
