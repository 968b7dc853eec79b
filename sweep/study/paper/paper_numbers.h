// The numbers of the paper, each as printed and as the program finds it another way.
#pragma once
#include "analysis/joint/joint.h"

#include <string>
#include <vector>

namespace stickslip {

/// The joint that all figures are about: m = 1 kg, A = 1 N, B = 1.5 N, L = 10 µm, V_0 = V* = 1 mm/s. The paper prints
/// no parameters of its own figures; only their shapes can be compared.
Joint paper_joint();

/// A statement of the paper, as printed or as its formula gives it, beside what the program computes another way.
struct PaperNumber {
    std::string equation, statement;  ///< mark-up
    double printed, computed;
    Quantity quantity;
};
std::vector<PaperNumber> paper_numbers();

/// Relative difference up to which a number counts as met; what (28) and (37) leave open is a limit.
inline constexpr double figure_tolerance = 1e-6;

/// Where steady friction ends to fall with velocity, range A of (7); it is looked for between the two velocities.
double end_of_falling_friction(const Friction& friction, double slow, double fast);

}  // namespace stickslip
