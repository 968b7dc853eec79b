// The option --ideal-loop, and what it leaves out, said by the verbs whose answers do not say it themselves.
#pragma once
#include "analysis/joint/joint.h"
#include "sweep/files/toml/asked_axes.h"

#include <CLI/CLI.hpp>

namespace stickslip {

void add_ideal_loop(CLI::App& verb, bool& ideal_loop);

/// To standard error: which keys of the loop the answer is without, and whether the joint as described slides smoothly.
/// Nothing where the joint has the ideal loop anyway.
void say_left_out(const Joint& described);

/// Puts the ideal loop in place of the joint's own, and says so.
void leave_loop_out(Asked& asked);

}  // namespace stickslip
