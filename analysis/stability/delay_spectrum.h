// The rightmost roots of joints whose friction has delays or a table: infinitely many roots, of which those matter.
#pragma once
#include <complex>
#include <vector>

#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// Roots near and right of the imaginary axis, at most 40: eigenvalues of the joint with the recent velocities of each
/// remembering body sampled at Chebyshev nodes, then Newton on the characteristic function.
/// Source: Breda, Maset & Vermiglio, Pseudospectral differencing methods for characteristic roots of delay differential
/// equations, SIAM J. Sci. Comput. 27 (2005).
std::vector<std::complex<double>> rightmost_roots(const LinearJoint& joint);

/// The largest real part among `roots` if counting finds none further right; else the abscissa by bisection on counts.
double confirmed_abscissa(const LinearJoint& joint, const std::vector<std::complex<double>>& roots);

}  // namespace stickslip
