// Small multiples of a sweep with more than two axes: the first chart at several values of the third axis and the
// fourth.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/panels.h"

namespace stickslip {

Figure multiples_figure(const Multiples& multiples, const PanelsAnswer& answer, Units units);

}  // namespace stickslip
