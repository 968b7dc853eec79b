// Sentences and tables of a set point that is held without hunting.
#pragma once
#include <string>
#include <vector>

#include "analysis/base/field.h"
#include "analysis/results/report.h"
#include "analysis/results/set_point_design.h"

namespace stickslip {

/// "Coulomb push towards the set point" and so on.
std::string way_text(SetPointWay way);

/// What is best and why it does not hunt, mark-up.
std::string set_point_design_text(const SetPointDesign& design, Units units);
/// Every way, and the proofs of the best one.
std::vector<Table> set_point_design_tables(const SetPointDesign& design, Units units);

}  // namespace stickslip
