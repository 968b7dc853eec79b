// Eigenvalues of a matrix, those that stand on its diagonal to the last digit.
#pragma once
#include <Eigen/Core>

namespace stickslip {

/// Empty where the matrix is not finite. A state on which no other depends, or that depends on no other, has its own
/// rate as eigenvalue: filters, integrators and friction states that the motion does not notice are exact. The others
/// are those of the balanced rest.
Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix);

}  // namespace stickslip
