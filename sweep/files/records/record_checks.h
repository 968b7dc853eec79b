// What looks wrong about a record that reads well: units, gaps, a motor that was off. Internal to sweep/files.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/joint/joint.h"
#include "analysis/results/note.h"

#include <vector>

namespace stickslip::files {

/// Codes, see Note; those by which two things that were given contradict each other are the ones that contradicts()
/// names. Suspicions compare signals with one another and with the joint; they never change data.
/// `unit_named`: the layout says in which unit the position is, so that long travel is no sign of another one.
std::vector<Note> suspicions(const Record& record, const Joint& joint, bool unit_named = false);

}  // namespace stickslip::files
