// How far a design is from its boundaries, as a page.
#pragma once
#include "analysis/results/report.h"
#include "sweep/words/margins_text.h"

namespace stickslip {

Report margins_report(const MarginsAnswer& answer);

}  // namespace stickslip
