// The linear verdict in words, for the report and the terminal.
#pragma once
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/results/report.h"
#include "analysis/stability/verdict.h"

#include <string>

namespace stickslip {

/// The answer in one sentence, in chart mark-up. `bistable`: what the linear theory calls stable is half of the answer,
/// a large enough disturbance ends in stick-slip. `rests`: what does not slide on stays at rest.
std::string verdict_text(const Joint& joint, const LinearVerdict& verdict, bool bistable = false, bool rests = false);

/// Every number of the verdict with its unit.
Table linear_table(const Joint& joint, const LinearVerdict& verdict);

/// Every number of the nonlinear verdict with its unit.
Table nonlinear_table(const Joint& joint, const NonlinearVerdict& verdict);

/// What a cycle does for the share of its period that is `stick_fraction`: a motion backwards is no rest.
std::string rest_text(const NonlinearVerdict& verdict);

/// Why a row has no verdict, in words.
std::string reason_text(Reason reason);

/// Why a verdict is open, in its own words where it has some; empty where nothing is open.
std::string reason_text(const NonlinearVerdict& verdict);

}  // namespace stickslip
