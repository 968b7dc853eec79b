// Why a verdict is open, in words.
#pragma once
#include "analysis/results/nonlinear_verdict.h"

#include <string>

namespace stickslip {

/// Why a row has no verdict, in words.
std::string reason_text(Reason reason);

/// Why a verdict is open, in its own words where it has some; empty where nothing is open.
std::string reason_text(const NonlinearVerdict& verdict);

}  // namespace stickslip
