// Which gains of a loop were searched for stability. Internal to sweep/words.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/loop/loop_use.h"

#include <algorithm>

namespace stickslip {

/// A real force loop has no k_p of its own that could be turned, a cascade there no k_v: neither was searched.
inline bool searched_in_k_p(const Joint& joint)
{
    return loop_kind(joint) == LoopKind::ideal || joint.control.kind == ControlKind::position;
}

inline bool searched_in_k_v(const Joint& joint, const LoopUse& loop)
{
    const auto& used = loop.used;
    const bool cascade = std::find(used.begin(), used.end(), "control.position_gain") != used.end();
    return loop.kind == LoopKind::ideal || (joint.control.kind == ControlKind::position && !cascade);
}

}  // namespace stickslip
