// The rightmost roots of joints whose friction has delays or a table: infinitely many roots, of which those matter.
#pragma once
#include <complex>
#include <vector>

#include "analysis/stability/linear_joint.h"
#include "analysis/stability/winding.h"

namespace stickslip {

/// max Re s: the real part of a root found by Newton's method right of which counting finds none; where Newton finds
/// none, bisection on counts. NaN if the joint is not finite or the roots cannot be counted.
double delayed_abscissa(const LinearJoint& joint);

/// The rightmost roots, descending in the real part: every root right of the last of them, as counting confirms. Some
/// twenty to forty; fewer where Newton's method does not find one of those that were counted.
std::vector<std::complex<double>> rightmost_roots(const LinearJoint& joint);

/// Roots with Im s ≥ 0 that Newton's method finds from `expected` and from the `most` places of a line where the phase
/// turns fastest: those near the line among them, as a rule. In no order.
std::vector<std::complex<double>> roots_near(const LinearJoint& joint, const LineCount& line, std::size_t most,
                                             const std::vector<std::complex<double>>& expected);

}  // namespace stickslip
