// What a cause does to the stability map: the stable gains without and with it. Shared by the pages of a diagnosis.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"

#include <string>

namespace stickslip {

struct MovedBoundary {
    Table table;
    std::vector<Figure> figures;  ///< ends of stable k_p over V_0 for both joints, where either has one
    std::string sentence;         ///< what happens to the safe gains
};

/// Linear theory at `speed` and from a hundredth to twice of it. `with` names the second joint: "with stribeck". A
/// joint without a verdict (no such theory for its model, no velocity) says why in its column; nothing is thrown.
MovedBoundary moved_boundary(const Joint& before, const Joint& after, double speed, const std::string& with);

/// The same as a section of a page, with a text after the sentence.
Section moved_section(MovedBoundary moved, const std::string& text = "");

}  // namespace stickslip
