// What the options of a nonlinear verdict ask of a loop that is followed tick by tick, and its answer in their terms.
#pragma once
#include "analysis/simulation/attractor/nonlinear.h"
#include "analysis/simulation/sampled/loop_verdict.h"

namespace stickslip {

LoopQuestion loop_question(const NonlinearOptions& options);
NonlinearVerdict verdict_of(const LoopVerdict& found, const NonlinearOptions& options);

}  // namespace stickslip
