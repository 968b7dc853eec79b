// The outcome of a check as a small page: old and new boundaries on one chart each, and what failed.
#pragma once
#include "analysis/loop/loop_use.h"
#include "analysis/results/report.h"
#include "sweep/study/check/boundaries.h"
#include "sweep/study/check/numbers.h"

#include <vector>

namespace stickslip {

Report check_report(const Spec& spec, const std::vector<Deviation>& deviations,
                    const std::vector<ChangedNumber>& changed, const LoopUse& loop, bool design_lost,
                    const std::string& command);

/// "friction.memory.L 10 µm → 11 µm"
std::string changed_text(const Spec& spec, const ChangedNumber& changed);

}  // namespace stickslip
