// The option --ideal-loop, and what it leaves out, said by the verbs whose answers do not say it themselves.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/files/toml/asked_axes.h"
#include "sweep/study/left_out_loop.h"

#include "sweep/program/verbs/command_line.h"

namespace stickslip {

void add_ideal_loop(Verb& verb, bool& ideal_loop);

/// Puts the ideal loop in place of the joint's own, and says to standard error which keys of the loop the answer is
/// without, and whether the joint as described slides smoothly. Nothing where the joint has the ideal loop anyway.
std::optional<LeftOutLoop> leave_loop_out(Asked& asked);
/// Throws BadInput for an axis over what is left out.
std::optional<LeftOutLoop> leave_loop_out(Spec& spec);

/// Throws BadInput for an axis over what an ideal loop has not.
void refuse_left_out(const Joint& ideal, const std::vector<Axis>& axes);

}  // namespace stickslip
