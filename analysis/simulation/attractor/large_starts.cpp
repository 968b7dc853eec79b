#include "analysis/simulation/attractor/large_starts.h"

#include "analysis/simulation/attractor/large_disturbance.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace stickslip {
namespace {

constexpr double pulls[] = {1.25, -1.25,
                            3.0};       ///< of the spring, in V_0/|s|: a little and far beyond what stops the mass
constexpr double lightly_damped = 0.1;  ///< −Re s/|s| of modes that a cycle may live on
constexpr double swing = 0.9;           ///< of its steady speed, of the body that a mode moves most
constexpr double same = 1e-6;           ///< relative distance of one mode computed twice

/// Swings of the oscillating modes other than `mode` that hardly decay. Velocities stand from `first` to `last`.
std::vector<FlowVector> swings(const Flow& flow, const SlowMode& mode, int first, int last)
{
    const FlowVector scale = flow.scale();
    FlowMatrix J;
    flow.jacobian(mode.steady, J);
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * J * scale.asDiagonal();
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(scaled);
    std::vector<FlowVector> starts;
    for (Eigen::Index i = 0; i < scaled.rows(); ++i) {
        const auto s = solver.eigenvalues()[i];
        const bool known =
            std::abs(s - mode.s) < same * std::abs(s) || std::abs(std::conj(s) - mode.s) < same * std::abs(s);
        if (!(s.imag() > 0) || known || s.real() < -lightly_damped * std::abs(s)) continue;
        const Eigen::VectorXd real = solver.eigenvectors().col(i).real();
        const double speed = real.segment(first, last - first).lpNorm<Eigen::Infinity>();
        if (speed > 0) starts.push_back(mode.steady + swing / speed * scale.cwiseProduct(FlowVector(real)));
    }
    return starts;
}

}  // namespace

LargeStarts large_starts(const SlidingFlow& flow, const SlowMode& mode)
{
    LargeStarts starts{{disturbed(flow, mode, DisturbanceKind::start, near_rest_start)}};
    const bool forgets = flow.can_rest() || mode.s.imag() == 0 || (flow.logarithmic && flow.states < 2);
    if (forgets) return starts;
    const double reach = flow.V0 / std::abs(mode.s);
    for (const double pull : pulls) starts.y.push_back(disturbed(flow, mode, DisturbanceKind::offset, pull * reach));
    starts.tried = LargerTried::pulls;
    return starts;
}

LargeStarts large_starts(const ChainFlow& flow, const SlowMode& mode)
{
    LargeStarts starts{{disturbed(flow, mode, DisturbanceKind::start, near_rest_start)}};
    const auto others = swings(flow, mode, flow.bodies, 2 * flow.bodies);
    if (others.empty()) return starts;
    starts.y.insert(starts.y.end(), others.begin(), others.end());
    starts.tried = LargerTried::swings;
    return starts;
}

LargeStarts large_starts(const DelayedFlow& flow, const SlowMode& mode)
{
    return {{disturbed(flow, mode, DisturbanceKind::start, near_rest_start)}};
}

}  // namespace stickslip
