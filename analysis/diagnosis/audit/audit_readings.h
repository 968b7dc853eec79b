// What the audit reads off records without the controller: the grid of readings, a supply that sags, the step and the
// plateau of commands. Internal to analysis/diagnosis/audit.
#pragma once
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/fit/fit.h"

#include <vector>

namespace stickslip::gap {

void audit_grid(std::vector<Case>& cases, Audit& result);

/// A logged supply that falls with the motor's current: the source has a resistance. The record's own supply then gives
/// way to the one without current and the resistance, so that the joint after the audit explains what the joint before
/// does not. A source that is off by the same voltage all the time has none.
void audit_supply(std::vector<Case>& cases, Audit& result);

/// The step in which commands are given, as a part of their rms; the largest of all records.
double command_rounding(const std::vector<Case>& cases);

/// A plateau of the command below the documented limit, where the controller wanted more.
double observed_limit(const std::vector<Case>& cases);

}  // namespace stickslip::gap
