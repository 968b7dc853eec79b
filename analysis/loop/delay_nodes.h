// Something that acts a while after it arose, as a finite system: Chebyshev nodes over what is on its way.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace stickslip {

/// row x(t − delay) pushes along `input`.
struct DelayLine {
    Eigen::VectorXd input;
    Eigen::RowVectorXd row;
    double delay;
};

/// ẋ = A x + Σ input row x(t − delay): the states, then `nodes` nodes of each line; those without a delay are in A.
Eigen::MatrixXd with_nodes(Eigen::MatrixXd A, std::vector<DelayLine> lines, int nodes);

}  // namespace stickslip
