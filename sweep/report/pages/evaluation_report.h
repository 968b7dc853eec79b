// The page about one joint: what `evaluate -o` writes.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/evaluation.h"

namespace stickslip {

/// Without its provenance. `charts` are those of the evaluation.
Report evaluation_report(const JointEvaluation& evaluation, const EvaluationCharts& charts);

}  // namespace stickslip
