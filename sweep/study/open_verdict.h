// Whether an answer about the nonlinear joint lacks a part, or shows the opposite of the linear theory.
#pragma once
#include "analysis/results/nonlinear_verdict.h"
#include "analysis/stability/verdict.h"

#include <string>
#include <vector>

namespace stickslip {

/// How the motion ends is undecided, or it slides and whether it does so after larger disturbances is.
inline bool is_open(const NonlinearVerdict& v)
{
    const bool half = v.outcome == Outcome::stable_sliding && v.region == NonlinearRegion::undecided;
    return half || v.outcome == Outcome::undecided || v.outcome == Outcome::solver_failure;
}

/// Keys of the terms that the linear theory lacks, where the motion does the opposite of what it says; empty where the
/// two agree, or where it lacks nothing that matters.
inline std::vector<std::string> contradicting_terms(const LinearVerdict& linear, const NonlinearVerdict& motion)
{
    const bool grows = motion.region == NonlinearRegion::stick_slip;
    const bool decays = motion.region == NonlinearRegion::stable || motion.region == NonlinearRegion::bistable;
    std::vector<std::string> keys;
    if (linear.steady.reason != Reason::none || linear.state_variable.neutral) return keys;
    if (!(linear.state_variable.stable ? grows : decays)) return keys;
    for (const auto& term : linear.loop.not_used)
        if (term.matters) keys.push_back(term.key);
    return keys;
}

}  // namespace stickslip
