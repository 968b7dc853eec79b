#include "analysis/loop/delay_nodes.h"

#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

using std::numbers::pi;

/// Differentiation on x_j = cos(jπ/N): L. N. Trefethen, Spectral Methods in MATLAB, 2000, chapter 6.
Eigen::MatrixXd differentiation(int nodes)
{
    const auto x = [&](int j) { return std::cos(j * pi / nodes); };
    const auto c = [&](int j) { return (j == 0 || j == nodes ? 2.0 : 1.0) * (j % 2 ? -1 : 1); };
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(nodes + 1, nodes + 1);
    for (int i = 0; i <= nodes; ++i)
        for (int j = 0; j <= nodes; ++j)
            if (i != j) D(i, j) = c(i) / c(j) / (x(i) - x(j));
    for (int i = 0; i <= nodes; ++i) D(i, i) = -D.row(i).sum();
    return D;
}

}  // namespace

Eigen::MatrixXd with_nodes(Eigen::MatrixXd A, std::vector<DelayLine> lines, int nodes)
{
    const auto n = A.rows();
    std::erase_if(lines, [&](const DelayLine& line) {
        if (line.delay > 0) return false;
        A += line.input * line.row;
        return true;
    });
    const Eigen::MatrixXd D = differentiation(nodes);
    const auto size = n + nodes * static_cast<Eigen::Index>(lines.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(size, size);
    M.topLeftCorner(n, n) = A;
    auto at = n;
    for (const auto& line : lines) {  // from −delay to 0
        const Eigen::MatrixXd own = 2 / line.delay * D;
        M.col(at + nodes - 1).head(n) = line.input;
        M.block(at, at, nodes, nodes) = own.bottomRightCorner(nodes, nodes);
        M.block(at, 0, nodes, n) = own.col(0).tail(nodes) * line.row;
        at += nodes;
    }
    return M;
}

}  // namespace stickslip
