// Signals that no record of this joint can hold: beyond a documented limit, unsigned, wrapped, another unit of time.
#pragma once
#include "sweep/files/records/record_checks.h"

namespace stickslip::files {

/// Every one contradicts the joint and is no cause of a gap. `time_unit_named`: the layout says in which unit the time
/// is.
std::vector<Note> impossible_signals(const Record& record, const Joint& joint, bool time_unit_named);

}  // namespace stickslip::files
