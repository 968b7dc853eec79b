// Which terms of a joint an answer at a set point has a place for, and how.
#pragma once
#include "analysis/joint/joint.h"

#include <string>
#include <vector>

namespace stickslip {

/// Keys that the joint states and no answer at a set point has a place for.
std::vector<std::string> unused_at_rest(const Joint& joint);

/// Whether one of them is large enough to change an answer. `per_signal`: effort per command.
bool matters_at_rest(const Joint& joint, double per_signal);

/// Whether motions are followed tick by tick in the joint's own loop: closed forms and events know neither its ticks
/// nor its delays, filters, encoder steps and sagging supply, nor a load that changes with position.
bool is_simulated(const Joint& joint);

}  // namespace stickslip
