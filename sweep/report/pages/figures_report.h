// The figures and numbers of the paper, computed anew: what `stickslip figures` writes.
#pragma once
#include "analysis/results/report.h"
#include "sweep/study/paper/paper_numbers.h"

#include <string>
#include <vector>

namespace stickslip {

/// Figs. 1a, 1b, 2 and 3.
Section friction_figures();

/// §4 and §5: the regions of stability, (34), the root locus, and what both theories demand of Armstrong's joint.
Section stability_figures();

/// A joint of each lumped model, for its drawing and its numbers: Figs. 4, 5, 6 (twice), 7a and 7b.
struct PaperModel {
    std::string id, title;
    Joint joint;
};
std::vector<PaperModel> paper_models();

/// All of it as one page.
Report figures_report();

}  // namespace stickslip
