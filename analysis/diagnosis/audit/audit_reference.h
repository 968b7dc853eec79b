// The controller audit where the reference was not logged.
#pragma once
#include "analysis/diagnosis/audit/audit.h"

namespace stickslip::gap {

/// A reference is smooth, the encoder's noise and grid are not, and both pass through the same controller: fourth
/// differences of the logged command follow those of the reading and of its velocity estimate with the true gains.
/// Samples in which the reference jumps or bends, or a limit was touched, are left out. Corrects the joints and adds
/// findings and a note; does nothing where the readings are too smooth to tell, and of a controller that is more than
/// k_p and k_v.
void audit_without_reference(std::vector<Case>& cases, double limit, Audit& result);

}  // namespace stickslip::gap
