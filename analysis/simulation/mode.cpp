#include "analysis/simulation/mode.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

States states_of(const SlidingFlow& flow, const FlowVector& y)
{
    States theta{};
    for (int i = 0; i < flow.states; ++i) theta[i] = y[2 + i];
    return theta;
}

/// Moves the states so that friction takes the value `wanted` at V; along ∂f/∂θ in units of each state's scale.
void set_friction(const SlidingFlow& flow, double V, double wanted, FlowVector& y)
{
    const FlowVector scale = flow.scale();
    for (int round = 0; round < 30; ++round) {
        const auto r = respond(flow.friction, V, states_of(flow, y));
        double slope = 0;
        for (int i = 0; i < flow.states; ++i) slope += std::pow(r.by_state[i] * scale[2 + i], 2);
        if (!(slope > 0)) return;
        const double step = (wanted - r.force) / slope;
        for (int i = 0; i < flow.states; ++i) y[2 + i] += step * r.by_state[i] * scale[2 + i] * scale[2 + i];
        if (std::abs(wanted - r.force) < 1e-14 * (std::abs(wanted) + std::abs(r.force))) return;
    }
}

}  // namespace

double SlowMode::window() const
{
    const double turn = 2 * std::numbers::pi / std::abs(s.imag());
    const double factor = std::log(3.0) / std::abs(s.real());
    return std::min(turn, factor);
}

SlowMode slow_mode(const Flow& flow)
{
    SlowMode mode;
    mode.steady = flow.steady();
    const FlowVector scale = flow.scale();
    FlowMatrix J;
    flow.jacobian(mode.steady, J);
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * J * scale.asDiagonal();
    if (!scaled.allFinite()) return mode;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(scaled.transpose());
    Eigen::Index largest = 0;
    for (Eigen::Index i = 1; i < scaled.rows(); ++i)
        if (solver.eigenvalues()[i].real() > solver.eigenvalues()[largest].real()) largest = i;
    mode.s = solver.eigenvalues()[largest];
    mode.left = scale.cwiseInverse().cast<std::complex<double>>().cwiseProduct(solver.eigenvectors().col(largest));
    return mode;
}

double default_size(const SlidingFlow& flow, const SlowMode& mode, DisturbanceKind kind)
{
    switch (kind) {
        case DisturbanceKind::position:
        case DisturbanceKind::offset:
            return small_disturbance * flow.V0 / std::abs(mode.s);
        case DisturbanceKind::velocity:
            return small_disturbance * flow.V0;
        case DisturbanceKind::impulse:
            return small_disturbance * flow.V0 * flow.inertia;
        case DisturbanceKind::state:
            return small_disturbance * std::abs(flow.k_p) * flow.V0 / std::abs(mode.s);
        case DisturbanceKind::start:
            return 1 - small_disturbance;
    }
    return missing;
}

FlowVector disturbed(const SlidingFlow& flow, DisturbanceKind kind, double size)
{
    FlowVector y = flow.steady();
    const auto set_speed = [&](double V) { y[1] = flow.logarithmic ? std::log(V / flow.V0) : V; };
    switch (kind) {
        case DisturbanceKind::position:
            y[0] = size;
            set_friction(flow, flow.V0, flow.steady_friction - flow.k_p * size, y);
            break;
        case DisturbanceKind::velocity:
            set_speed(flow.V0 + size);
            set_friction(flow, flow.V0 + size, flow.steady_friction - flow.k_v * size, y);
            break;
        case DisturbanceKind::impulse:
            set_speed(flow.V0 + size / flow.inertia);
            break;
        case DisturbanceKind::offset:
            y[0] = size;
            break;
        case DisturbanceKind::state:
            set_friction(flow, flow.V0, flow.steady_friction + size, y);
            break;
        case DisturbanceKind::start: {
            const double V = flow.can_rest() ? 0 : std::max(size, 1e-12) * flow.V0;
            const auto theta = steady_state(flow.friction, V);
            for (int i = 0; i < flow.states; ++i) y[2 + i] = theta[i];
            const double carried = V == 0 ? flow.static_force() : respond(flow.friction, V, theta).force;
            y[0] = (flow.steady_friction - carried - flow.k_v * (V - flow.V0)) / flow.k_p;
            set_speed(V);
            break;
        }
    }
    return y;
}

}  // namespace stickslip
