// How a record begins.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/results/note.h"

namespace stickslip::gap {

/// Cut from a longer one, a record starts in motion. It is taken to, where that predicts its first rows and rest does
/// not.
void find_start(Case& c, std::vector<Note>& notes);

/// What the controller's integral held as the record began: by how much the first commands are beyond those of a
/// controller that began without, per its gain. Nothing is changed where no command or no reference was logged, or
/// where the first rows do not agree on it.
void find_integral(Case& c);

}  // namespace stickslip::gap
