// Line charts with their labels and words: what every chart of the linear theory is made with.
#pragma once
#include "analysis/results/report.h"

#include <string>
#include <string_view>

namespace stickslip {

/// "velocity V_{0}" and its unit.
AxisName axis_label(std::string_view name, Quantity quantity, Units units);

/// A chart with its words; the finding is what a screen reader says and stands first in the caption.
Figure line_figure(std::string id, Picture chart, std::string finding, std::string reading);

}  // namespace stickslip
