// The report of a sweep: verdict first, then the numbers with their limits, alerts, charts, and how to reproduce it.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/spec.h"
#include "sweep/study/sweep_answer.h"

namespace stickslip {

/// Composes the page of a sweep from its points and the answers stored beside them; nothing is computed.
Report stability_report(const Spec& spec, const SweepSummary& summary, const SweepAnswer& answer);

}  // namespace stickslip
