// Whether an answer about the nonlinear joint lacks a part.
#pragma once
#include "analysis/results/nonlinear_verdict.h"

namespace stickslip {

/// How the motion ends is undecided, or it slides and whether it does so after larger disturbances is.
inline bool is_open(const NonlinearVerdict& v)
{
    const bool half = v.outcome == Outcome::stable_sliding && v.region == NonlinearRegion::undecided;
    return half || v.outcome == Outcome::undecided || v.outcome == Outcome::solver_failure;
}

}  // namespace stickslip
