// How a record begins.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/results/note.h"

namespace stickslip::gap {

/// Cut from a longer one, a record starts in motion. It is taken to, where that predicts its first rows and rest does
/// not.
void find_start(Case& c, std::vector<Note>& notes);

}  // namespace stickslip::gap
