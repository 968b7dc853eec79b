// A record that was interrupted is several.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/results/note.h"

#include <string>
#include <vector>

namespace stickslip::gap {

/// "run.csv from 12.5 s": what a part of a record that begins there is called.
std::string name_of_part(const std::string& record, double begins);

/// The record from hole to hole, where nothing is known of what the joint did for many rows: a simulation across would
/// hold the last command all the while. Each piece keeps its times; those after a hole start in motion or at rest, as
/// their motion says. `notes` names the holes.
std::vector<Record> pieces(const Record& record, std::vector<Note>& notes);

}  // namespace stickslip::gap
