// Why a verdict is open, in words.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/nonlinear_verdict.h"

#include <string>

namespace stickslip {

/// Why a row has no verdict, in words.
std::string reason_text(Reason reason);

/// The same of a joint: names the combination of its friction that is not computed, where it is one of friction alone.
std::string reason_text(Reason reason, const Joint& joint);

/// Why a verdict is open, in its own words where it has some; empty where nothing is open.
std::string reason_text(const NonlinearVerdict& verdict);

}  // namespace stickslip
