// A loop behind dead time as a finite system: Chebyshev nodes over what is on its way.
#include <cmath>
#include <numbers>

#include "analysis/loop/delayed_loop.h"

namespace stickslip {

using std::numbers::pi;

Eigen::MatrixXd delayed_matrix(const DelayedLoop& loop, double gain, int nodes)
{
    const auto n = loop.A.rows();
    /// Something that acts a while after it arose.
    struct Line {
        Eigen::VectorXd input;
        Eigen::RowVectorXd row;
        double delay;
    };
    Eigen::MatrixXd A = loop.A;
    std::vector<Line> lines{{loop.input, loop.held - gain * loop.output, loop.delay}};
    for (const auto& f : loop.friction)
        for (const auto& d : f.delays) lines.push_back({d.weight * f.push, f.speed, d.time});
    std::erase_if(lines, [&](const Line& line) {
        if (line.delay > 0) return false;
        A += line.input * line.row;
        return true;
    });
    // differentiation on x_j = cos(jπ/N)
    const auto x = [&](int j) { return std::cos(j * pi / nodes); };
    const auto c = [&](int j) { return (j == 0 || j == nodes ? 2.0 : 1.0) * (j % 2 ? -1 : 1); };
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(nodes + 1, nodes + 1);
    for (int i = 0; i <= nodes; ++i)
        for (int j = 0; j <= nodes; ++j)
            if (i != j) D(i, j) = c(i) / c(j) / (x(i) - x(j));
    for (int i = 0; i <= nodes; ++i) D(i, i) = -D.row(i).sum();
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
