#include "analysis/boundary/continuation.h"

#include <Eigen/Dense>

namespace stickslip {

Eigen::VectorXd tangent_of(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& weight, const Eigen::VectorXd& along)
{
    const auto n = jacobian.cols();
    const Eigen::MatrixXd weighted = jacobian * weight.cwiseInverse().asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(weighted, Eigen::ComputeFullV);
    Eigen::VectorXd tangent = svd.matrixV().col(n - 1).cwiseQuotient(weight);
    if (tangent.dot(weight.cwiseAbs2().cwiseProduct(along)) < 0) tangent = -tangent;
    return tangent;
}

std::optional<CurveState> solve_on(const CurveSystem& system, const Eigen::VectorXd& guess,
                                   const Eigen::VectorXd& constraint, const Eigen::VectorXd& weight,
                                   const Eigen::VectorXd& along)
{
    constexpr int rounds = 4, steps = 5;
    constexpr double stalled = 0.3;  // a step that shrinks the residual less asks for a new Jacobian
    CurveState state;
    state.z = guess;
    auto F = system.residual(state.z);
    if (!F) return {};
    const auto n = guess.size();
    for (int round = 0; round < rounds; ++round) {
        const auto J = system.jacobian(state.z);
        if (!J || !J->allFinite()) return {};
        Eigen::MatrixXd square(n, n);
        square << *J, constraint.transpose();
        const Eigen::FullPivLU<Eigen::MatrixXd> lu(square);
        for (int k = 0; k < steps; ++k) {
            const double size = F->cwiseAbs().maxCoeff();
            if (size <= system.tolerance) {
                state.jacobian = *J;
                state.tangent = tangent_of(*J, weight, along);
                return state;
            }
            Eigen::VectorXd right(n);
            right << -*F, -constraint.dot(state.z - guess);
            const Eigen::VectorXd step = lu.solve(right);
            if (!step.allFinite() || step.cwiseProduct(weight).norm() > 1) return {};
            const Eigen::VectorXd moved = state.z + step;
            const auto G = system.residual(moved);
            if (!G) return {};
            state.z = moved;
            const bool slow = !(G->cwiseAbs().maxCoeff() < stalled * size);
            F = G;
            if (slow) break;
        }
    }
    if (F->cwiseAbs().maxCoeff() > system.tolerance) return {};
    const auto J = system.jacobian(state.z);
    if (!J) return {};
    state.jacobian = *J;
    state.tangent = tangent_of(*J, weight, along);
    return state;
}

bool walk_curve(const CurveSystem& system, const CurveState& start, const CurveWalk& options,
                const std::function<bool(const CurveState&, const CurveState&)>& visit)
{
    CurveState here = start;
    double h = options.first_step;
    for (int i = 0; i < options.limit && h >= options.shortest_step;) {
        const Eigen::VectorXd weight = options.weight(here.z);
        const Eigen::VectorXd tangent = here.tangent / here.tangent.cwiseProduct(weight).norm();
        const Eigen::VectorXd constraint = weight.cwiseAbs2().cwiseProduct(tangent);
        const auto next = solve_on(system, here.z + h * tangent, constraint, weight, tangent);
        const double alike =
            next ? next->tangent.cwiseProduct(weight).normalized().dot(tangent.cwiseProduct(weight)) : -1;
        const double moved = next ? (next->z - here.z).cwiseProduct(weight).norm() : 0;
        if (!next || moved > 2 * h || (alike < std::cos(options.turn) && h > 4 * options.shortest_step)) {
            h *= 0.4;
            continue;
        }
        if (!visit(here, *next)) return true;
        here = *next;
        ++i;
        if (alike > std::cos(0.4 * options.turn)) h = std::min(1.6 * h, options.longest_step);
    }
    return false;
}

}  // namespace stickslip
