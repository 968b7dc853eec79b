#include "tests/oracles/matrices.h"

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

namespace stickslip::test {

Eigen::MatrixXd exponential(const Eigen::Ref<const Eigen::MatrixXd>& matrix)
{
    return matrix.exp();
}

LongMatrix exponential(const Eigen::Ref<const LongMatrix>& matrix)
{
    return matrix.exp();
}

double spectral_radius(const Eigen::Ref<const Eigen::MatrixXd>& matrix)
{
    return matrix.eigenvalues().cwiseAbs().maxCoeff();
}

long double spectral_radius(const Eigen::Ref<const LongMatrix>& matrix)
{
    return matrix.eigenvalues().cwiseAbs().maxCoeff();
}

double spectral_abscissa(const Eigen::Ref<const Eigen::MatrixXd>& matrix)
{
    return matrix.eigenvalues().real().maxCoeff();
}

}  // namespace stickslip::test
