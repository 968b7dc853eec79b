#include "analysis/simulation/solvers/rodas5p.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using rodas5p::stages;

FlowVector sum(const std::array<FlowVector, stages>& U, const rodas5p::Row& weights, int count, FlowVector start)
{
    for (int j = 0; j < count; ++j)
        if (weights[j] != 0) start += weights[j] * U[j];
    return start;
}

}  // namespace

FlowVector RodasStep::dense(double fraction) const
{
    std::array<FlowVector, 3> k;
    for (int r = 0; r < 3; ++r) k[r] = sum(U, rodas5p::dense[r], stages, FlowVector::Zero(y.size()));
    const double rest = 1 - fraction;
    return rest * y + fraction * (y1 + rest * (k[0] + fraction * (k[1] + fraction * k[2])));
}

void rodas5p_step(const Flow& flow, RodasStep& step)
{
    const int n = flow.size();
    FlowMatrix J;
    flow.jacobian(step.y, J);
    const FlowMatrix shifted = FlowMatrix::Identity(n, n) / (step.h * rodas5p::gamma) - J;
    const Eigen::PartialPivLU<FlowMatrix> solver(shifted);
    FlowVector rate;
    for (int i = 0; i < stages; ++i) {
        flow.rate(sum(step.U, rodas5p::a[i], i, step.y), rate);
        step.U[i] = solver.solve(sum(step.U, rodas5p::c[i], i, rate * step.h) / step.h);
    }
    step.y1 = sum(step.U, rodas5p::a[stages - 1], stages - 1, step.y) + step.U[stages - 1];
}

FlowMatrix rodas5p_step(const Flow& flow, RodasStep& step, const FlowMatrix& displacements)
{
    const int n = flow.size();
    FlowMatrix J;
    flow.jacobian(step.y, J);
    const FlowMatrix shifted = FlowMatrix::Identity(n, n) / (step.h * rodas5p::gamma) - J;
    const Eigen::PartialPivLU<FlowMatrix> solver(shifted);
    const FlowVector scale = flow.scale();
    std::array<FlowMatrix, stages> W;  // stages of Φ
    FlowVector rate;
    FlowMatrix J_stage, J_near;
    for (int i = 0; i < stages; ++i) {
        const FlowVector y = sum(step.U, rodas5p::a[i], i, step.y);
        flow.rate(y, rate);
        step.U[i] = solver.solve(sum(step.U, rodas5p::c[i], i, rate * step.h) / step.h);

        FlowMatrix phi = displacements, carried = FlowMatrix::Zero(n, displacements.cols());
        for (int j = 0; j < i; ++j) {
            if (rodas5p::a[i][j] != 0) phi += rodas5p::a[i][j] * W[j];
            carried += rodas5p::c[i][j] / step.h * W[j];
        }
        flow.jacobian(y, J_stage);
        // ∂(JΦ)/∂y · U_i by a difference along U_i, taken at the start of the step like J itself
        const double length = (step.U[i].cwiseQuotient(scale)).norm();
        FlowMatrix bend = FlowMatrix::Zero(n, n);
        if (length > 0) {
            const double small = 1e-7 / length;
            flow.jacobian(step.y + small * step.U[i], J_near);
            bend = (J_near - J) / small;
        }
        W[i] = solver.solve(J_stage * phi + carried + bend * displacements);
    }
    step.y1 = sum(step.U, rodas5p::a[stages - 1], stages - 1, step.y) + step.U[stages - 1];
    FlowMatrix phi = displacements;
    for (int j = 0; j + 1 < stages; ++j) phi += rodas5p::a[stages - 1][j] * W[j];
    return phi + W[stages - 1];
}

double scaled_error(const RodasStep& step, const FlowVector& scale, double rtol)
{
    double largest = 0;
    for (Eigen::Index i = 0; i < step.y.size(); ++i) {
        const double allowed = rtol * (scale[i] + std::max(std::abs(step.y[i]), std::abs(step.y1[i])));
        const double ratio = std::abs(step.error()[i]) / allowed;
        if (!(ratio <= largest)) largest = ratio;  // lets NaN through
        if (std::isnan(ratio)) return ratio;
    }
    return largest;
}

double first_step(const Flow& flow, const FlowVector& y)
{
    const FlowVector scale = flow.scale();
    FlowMatrix J;
    flow.jacobian(y, J);
    FlowVector rate;
    flow.rate(y, rate);
    const FlowMatrix scaled = scale.cwiseInverse().asDiagonal() * J * scale.asDiagonal();
    const double fastest = scaled.cwiseAbs().rowwise().sum().maxCoeff();
    const double motion = rate.cwiseQuotient(scale).cwiseAbs().maxCoeff();
    return 0.01 / (fastest + motion);
}

double step_factor(double error)
{
    if (!(error < 1e30)) return 0.1;
    return std::clamp(0.87 * std::pow(std::max(error, 1e-12), -0.2), 0.2, 5.0);
}

}  // namespace stickslip
