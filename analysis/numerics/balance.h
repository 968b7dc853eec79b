// Balancing of a matrix before its eigenvalues are computed.
#pragma once
#include <Eigen/Core>
#include <cmath>

namespace stickslip {

/// Parlett-Reinsch balancing by powers of two, so that the eigenvalue solver sees entries of one size.
/// Source: Parlett & Reinsch, Balancing a matrix for calculation of eigenvalues and eigenvectors (1969).
/// `units`, where given, is multiplied by the scale D of D⁻¹ A D.
template <class Matrix>
void balance(Matrix& matrix, Eigen::VectorXd* units = nullptr)
{
    constexpr int most = 100;  // each pass takes a twentieth of some row and column away; ten are many
    bool changed = true;
    for (int pass = 0; changed && pass < most; ++pass) {
        changed = false;
        for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
            // summed without the diagonal, which would swallow what is small beside it
            double row = 0, column = 0;
            for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
                if (k == i) continue;
                row += static_cast<double>(std::abs(matrix(i, k)));
                column += static_cast<double>(std::abs(matrix(k, i)));
            }
            if (!(row > 0 && column > 0) || !std::isfinite(row + column)) continue;
            const double factor = std::exp2(std::round(std::log2(row / column) / 2));
            if (column * factor + row / factor >= 0.95 * (column + row)) continue;
            matrix.col(i) *= factor;
            matrix.row(i) /= factor;
            if (units) (*units)[i] *= factor;
            changed = true;
        }
    }
}

}  // namespace stickslip
