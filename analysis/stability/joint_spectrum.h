// Stability and spectrum of joints with any number of bodies and any memory.
#pragma once
#include <Eigen/Core>
#include <complex>
#include <vector>

#include "analysis/numerics/polynomial_arithmetic.h"
#include "analysis/stability/linear_joint.h"

namespace stickslip {

/// ẏ = A y with y = (x_1 … x_n, v_1 … v_n, θ of body 1, θ of body 2, …, x and v of each neighbour), positions less
/// those of steady sliding. The part of a joint that is no state (delays, tables) is left out.
Eigen::MatrixXd state_matrix(const LinearJoint& joint);

/// What one unit of force on a body adds to ẏ: its acceleration, and that of neighbours which the mass matrix couples
/// to the link.
Eigen::VectorXd rates_per_force(const LinearJoint& joint, int body);

/// a and b of F = a + (k_p + k_v s) b, times the denominators of all G. Rational joints only.
struct RationalCharacteristic {
    Polynomial a, b;
};
RationalCharacteristic rational_characteristic(const LinearJoint& joint);

/// Whether all roots decay. Rational joints by Routh's scheme, without allocation and without computing roots; others
/// by counting (roots_right_of).
bool is_stable(const LinearJoint& joint);

/// All roots of a rational joint, or the rightmost of a joint with delays or a table; descending in the real part, each
/// polished on the characteristic function itself.
std::vector<std::complex<double>> spectrum(const LinearJoint& joint);

/// max Re s. With delays or a table the rightmost root found is confirmed by counting: none lies to its right. NaN if
/// that fails or the joint is not finite.
double spectral_abscissa(const LinearJoint& joint);

}  // namespace stickslip
