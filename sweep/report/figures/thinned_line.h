// Lines of long motions with no more samples than a picture shows.
#pragma once
#include "analysis/results/report.h"

namespace stickslip {

/// The same line for the eye. Where x ascends, as time does: of each of some thousand stretches the first, the lowest,
/// the highest and the last sample, so that no peak is lost. Any other curve: every n-th sample.
LineChart::Line thinned(LineChart::Line line);

}  // namespace stickslip
