// The controller of a log that is slower than its loop, by what averages over many rows.
#pragma once
#include "analysis/diagnosis/audit/audit.h"

namespace stickslip::gap {

/// Whether commands, references and positions were logged at some ticks of the loop only.
bool is_slow_log(const std::vector<Case>& cases);

/// Compares the command with the documented controller over readings that are interpolated between the rows. One after
/// the other the gain, the other term, the filter or the dead zone that leaves much less of it is a finding; a gain or
/// a term where it is off by clearly more than its error in all records together, and alike in each.
void audit_slow_log(std::vector<Case>& cases, double limit, Audit& result);

/// The same of the filter alone. Logged velocities that came out of it tell the gains better than readings do, and hide
/// the filter.
void audit_slow_filter(std::vector<Case>& cases, double limit, Audit& result);

}  // namespace stickslip::gap
