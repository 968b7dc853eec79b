// Both joints of a diagnosis over their gains, how they move, and the gains that would be right.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/corrected_gains.h"

#include <string>

namespace stickslip {

/// Adds charts, tables and a sentence to the section about the stability map. `with` names the corrected joint: "with
/// stribeck".
void add_corrected_gains(Section& section, const CorrectedGains& gains, Units units, const std::string& with);

}  // namespace stickslip
