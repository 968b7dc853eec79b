// The figures and numbers of the paper, computed anew: what `stickslip figures` writes.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/report.h"

#include <string>
#include <vector>

namespace stickslip {

/// The joint that all figures are about: m = 1 kg, A = 1 N, B = 1.5 N, L = 10 µm, V_0 = V* = 1 mm/s. The paper prints
/// no parameters of its own figures; only their shapes can be compared.
Joint paper_joint();

/// Figs. 1a, 1b, 2 and 3.
Section friction_figures();

/// §4 and §5: the regions of stability, (34), the root locus, and what both theories demand of Armstrong's joint.
Section stability_figures();

/// A statement of the paper, as printed or as its formula gives it, beside what the program computes another way.
struct PaperNumber {
    std::string equation, statement;  ///< mark-up
    double printed, computed;
    Quantity quantity;
};
std::vector<PaperNumber> paper_numbers();

/// Relative difference up to which a number counts as met; what (28) and (37) leave open is a limit.
inline constexpr double figure_tolerance = 1e-6;

/// A joint of each lumped model, for its drawing and its numbers: Figs. 4, 5, 6 (twice), 7a and 7b.
struct PaperModel {
    std::string id, title;
    Joint joint;
};
std::vector<PaperModel> paper_models();

/// All of it as one page.
Report figures_report();

}  // namespace stickslip
