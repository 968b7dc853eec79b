// Eigenvalues of a balanced matrix.
#pragma once
#include <Eigen/Core>

namespace stickslip {

/// Empty where the matrix is not finite.
Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd matrix);

}  // namespace stickslip
