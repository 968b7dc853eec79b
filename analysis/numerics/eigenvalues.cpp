#include "analysis/numerics/eigenvalues.h"

#include <Eigen/Dense>
#include <vector>

#include "analysis/numerics/balance.h"

namespace stickslip {
namespace {

using Eigen::Index;

/// The states that are coupled to others both ways. The others are found by taking away, again and again, one that is
/// not: what is left of the matrix stays block-triangular.
std::vector<Index> coupled_states(const Eigen::MatrixXd& matrix)
{
    const Index n = matrix.rows();
    std::vector<Index> others_in_row(n, 0), others_in_column(n, 0), alone;
    std::vector<bool> left(n, true);
    for (Index i = 0; i < n; ++i)
        for (Index k = 0; k < n; ++k)
            if (i != k && matrix(i, k) != 0) ++others_in_row[i], ++others_in_column[k];
    const auto take_if_alone = [&](Index i) {
        if (!left[i] || (others_in_row[i] != 0 && others_in_column[i] != 0)) return;
        left[i] = false;
        alone.push_back(i);
    };
    for (Index i = 0; i < n; ++i) take_if_alone(i);
    while (!alone.empty()) {
        const Index gone = alone.back();
        alone.pop_back();
        for (Index i = 0; i < n; ++i) {
            if (i == gone) continue;
            others_in_row[i] -= matrix(i, gone) != 0;
            others_in_column[i] -= matrix(gone, i) != 0;
            take_if_alone(i);
        }
    }
    std::vector<Index> coupled;
    for (Index i = 0; i < n; ++i)
        if (left[i]) coupled.push_back(i);
    return coupled;
}

}  // namespace

Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix)
{
    if (!matrix.allFinite()) return {};
    const auto coupled = coupled_states(matrix);
    Eigen::VectorXcd values = matrix.diagonal().cast<std::complex<double>>();
    if (coupled.empty()) return values;
    Eigen::MatrixXd rest = matrix(coupled, coupled);
    balance(rest);
    values(coupled) = rest.eigenvalues();
    return values;
}

}  // namespace stickslip
