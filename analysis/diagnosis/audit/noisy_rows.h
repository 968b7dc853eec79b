// Which command drives a record that was logged slower than the loop.
#pragma once
#include "analysis/diagnosis/fit/fit.h"

#include <vector>

namespace stickslip::gap {

/// Marks the cases whose rows carry noise into the prediction (Ticks::noisy_rows). The command of a tick contains what
/// the controller makes of the encoder's noise: differences that cancel from tick to tick. Of a log of every fifth tick
/// only each fifth of them is known, and these do not cancel: they push the simulated joint about. Where the controller
/// gives the logged commands but for such noise, its own commands from the positions alone are the better ones. Call it
/// after audit(), which corrects the controller.
void mark_noisy_rows(std::vector<Case>& cases);

}  // namespace stickslip::gap
