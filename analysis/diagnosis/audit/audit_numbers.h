// Numbers of the controller that enter its command nonlinearly: the filter, the limit of the integral, the speed of
// the push. Internal to analysis/diagnosis/audit.
#pragma once
#include "analysis/diagnosis/audit/audit.h"

namespace stickslip::gap {

/// What is left with at most one change of the terms.
double left_by_one(const std::vector<Case>& cases, double limit);

/// A filter of the velocity that is not the documented one. Corrected in the cases.
void find_filter(std::vector<Case>& cases, double limit, Audit& result);

/// A limit of the integral's share that is not the documented one. Corrected in the cases.
void find_integral_limit(std::vector<Case>& cases, double limit, Audit& result);

/// How fast the reference has to be for a Coulomb feed-forward that the document lacks. Set in the cases.
void find_coulomb_speed(std::vector<Case>& cases, double limit);

}  // namespace stickslip::gap
