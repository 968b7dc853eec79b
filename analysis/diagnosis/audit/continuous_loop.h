// Whether the loop that made the records runs without a clock: what its commands do between rows, and what velocity it
// feeds back.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/results/note.h"

#include <vector>

namespace stickslip::gap {

/// A joint file without `control.period` leaves open what its commands do between rows. They go straight where the
/// logged command is that of the logged velocity and these are no filtered differences of the readings, or where the
/// motion says so; held otherwise. One machine made all records, so that each must say it. Corrects the cases and adds
/// notes.
void find_continuous_loop(std::vector<Case>& cases, std::vector<Note>& notes);

}  // namespace stickslip::gap
