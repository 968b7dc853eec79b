// What a cause does to the stability map: the stable gains without and with it. Shared by the pages of a diagnosis.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"
#include "sweep/study/stable_windows.h"

#include <string>

namespace stickslip {

/// The sentence, what `text` adds to it, the table of both joints, and the ends of stable k_p over V_0 where either has
/// one. `with` names the second joint: "with stribeck". A joint without a verdict (no such theory for its model, no
/// velocity) says why in its column.
Section moved_section(const MovedBoundary& moved, Units units, const std::string& with, const std::string& text = "");

}  // namespace stickslip
