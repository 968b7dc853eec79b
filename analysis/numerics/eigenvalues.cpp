#include "analysis/numerics/eigenvalues.h"

#include <Eigen/Dense>

#include "analysis/numerics/balance.h"

namespace stickslip {

Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd matrix)
{
    if (!matrix.allFinite()) return {};
    balance(matrix);
    return matrix.eigenvalues();
}

}  // namespace stickslip
