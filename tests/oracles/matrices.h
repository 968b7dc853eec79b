// Exponentials and eigenvalues for the oracles, in one place because each takes seconds to compile.
#pragma once
#include <Eigen/Core>

namespace stickslip::test {

/// Where eigenvalues crowd around 1 and their distance from it counts.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

Eigen::MatrixXd exponential(const Eigen::Ref<const Eigen::MatrixXd>& matrix);
LongMatrix exponential(const Eigen::Ref<const LongMatrix>& matrix);

/// The largest magnitude of an eigenvalue.
double spectral_radius(const Eigen::Ref<const Eigen::MatrixXd>& matrix);
long double spectral_radius(const Eigen::Ref<const LongMatrix>& matrix);

/// The largest real part of an eigenvalue.
double spectral_abscissa(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

}  // namespace stickslip::test
