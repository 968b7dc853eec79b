// What a changed term of the controller is called, and the controller with it. Internal to analysis/diagnosis/audit.
#pragma once
#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/command_terms.h"

namespace stickslip::gap {

/// The controller with this term changed by a factor of 1 + value, or by the value itself.
void correct(Control& control, int term, double value, bool factor);

/// `corrected` has the term already.
AuditFinding finding_of(int term, const TermFit& fit, bool factor, const Control& corrected, double gain);

/// How much a term changes: a gain by a factor, the command by what is added to it, as a part of its rms.
double size_of(const CommandTerms& all, const TermFit& fit, int term);

/// Whether commands show the filter of the velocities. Where logged velocities stand in for the controller's own, it
/// acts in lost rows alone.
bool shows_filter(const std::vector<Case>& cases);

/// Of the reference and the readings.
double largest_error(const std::vector<Case>& cases);

}  // namespace stickslip::gap
