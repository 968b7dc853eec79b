#include "analysis/simulation/flows/mode.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stickslip {
namespace {

constexpr double rest_of_modes = 1e-12;  ///< per norm: eigenvalues of states that do not evolve

/// Moves the states so that friction takes the value `wanted` at V; along ∂f/∂θ in units of each state's scale. States
/// that do not evolve there stay.
void set_friction(const Friction& friction, double V, double wanted, const double* scale, double* theta)
{
    const int count = states(friction);
    for (int round = 0; round < 30; ++round) {
        States now{};
        std::copy_n(theta, count, now.begin());
        const auto r = respond(friction, V, now);
        double slope = 0;
        const auto moves = [&](int i) { return r.rate_by_state[i] != 0 || r.rate_by_velocity[i] != 0; };
        for (int i = 0; i < count; ++i)
            if (moves(i)) slope += std::pow(r.by_state[i] * scale[i], 2);
        if (!(slope > 0)) return;
        const double step = (wanted - r.force) / slope;
        for (int i = 0; i < count; ++i)
            if (moves(i)) theta[i] += step * r.by_state[i] * scale[i] * scale[i];
        if (std::abs(wanted - r.force) < 1e-14 * (std::abs(wanted) + std::abs(r.force))) return;
    }
}

double small_size(double V0, double k_p, double inertia, const SlowMode& mode, DisturbanceKind kind)
{
    switch (kind) {
        case DisturbanceKind::position:
        case DisturbanceKind::offset:
            return small_disturbance * V0 / std::abs(mode.s);
        case DisturbanceKind::velocity:
            return small_disturbance * V0;
        case DisturbanceKind::impulse:
            return small_disturbance * V0 * inertia;
        case DisturbanceKind::state:
            return small_disturbance * std::abs(k_p) * V0 / std::abs(mode.s);
        case DisturbanceKind::start:
            return 1 - small_disturbance;
    }
    return missing;
}

}  // namespace

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
    const Eigen::EigenSolver<Eigen::MatrixXd> columns(scaled);
    const auto resting = (scaled.rowwise().lpNorm<Eigen::Infinity>().array() == 0).count();
    const double smallest = resting > 0 ? rest_of_modes * scaled.norm() : 0;
    Eigen::Index largest = -1, same = 0;
    for (Eigen::Index i = 0; i < scaled.rows(); ++i) {
        const auto s = solver.eigenvalues()[i];
        if (std::abs(s) < smallest) continue;
        if (largest < 0 || s.real() > solver.eigenvalues()[largest].real()) largest = i;
    }
    if (largest < 0) return mode;
    mode.s = solver.eigenvalues()[largest];
    mode.fastest = solver.eigenvalues().cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < scaled.rows(); ++i)
        if (std::abs(columns.eigenvalues()[i] - mode.s) < std::abs(columns.eigenvalues()[same] - mode.s)) same = i;
    mode.left = scale.cwiseInverse().cast<std::complex<double>>().cwiseProduct(solver.eigenvectors().col(largest));
    mode.right = scale.cast<std::complex<double>>().cwiseProduct(columns.eigenvectors().col(same));
    return mode;
}

LinearRates linear_rates(const Flow& flow)
{
    FlowMatrix J;
    flow.jacobian(flow.steady(), J);
    const Eigen::VectorXcd modes = J.eigenvalues();
    const double largest = modes.cwiseAbs().maxCoeff();
    LinearRates rates;
    rates.fastest = largest;
    for (const auto& s : modes)
        if (std::abs(s) > neutral_mode * largest) {
            rates.slowest = std::min(rates.slowest, std::abs(s));
            rates.abscissa = std::max(rates.abscissa, s.real());
        }
    return rates;
}

double default_size(const SlidingFlow& flow, const SlowMode& mode, DisturbanceKind kind)
{
    return small_size(flow.V0, flow.k_p, flow.inertia, mode, kind);
}

double default_size(const ChainFlow& flow, const SlowMode& mode, DisturbanceKind kind)
{
    return small_size(flow.V0, flow.loop.k_p, flow.body[flow.link()].inertia, mode, kind);
}

void push(const SlidingFlow& flow, FlowVector& y, double impulse)
{
    const double gain = impulse / flow.inertia;
    y[1] += flow.logarithmic ? std::log1p(gain / flow.velocity(y)) : gain;
}

void push(const ChainFlow& flow, FlowVector& y, double impulse)
{
    const int link = flow.link();
    const auto& b = flow.body[link];
    const double gain = impulse / b.inertia;
    y[flow.bodies + link] += b.logarithmic ? std::log1p(gain / flow.velocity(y, link)) : gain;
}

FlowVector disturbed(const SlidingFlow& flow, const SlowMode&, DisturbanceKind kind, double size)
{
    FlowVector y = flow.steady();
    const FlowVector scale = flow.scale();
    const auto balance = [&](double V, double wanted) {
        set_friction(flow.friction, V, wanted, scale.data() + 2, y.data() + 2);
    };
    const auto set_speed = [&](double V) { y[1] = flow.logarithmic ? std::log(V / flow.V0) : V; };
    switch (kind) {
        case DisturbanceKind::position:
            y[0] = size;
            balance(flow.V0, flow.steady_friction - flow.k_p * size);
            break;
        case DisturbanceKind::velocity:
            set_speed(flow.V0 + size);
            balance(flow.V0 + size, flow.steady_friction - flow.k_v * size);
            break;
        case DisturbanceKind::impulse:
            push(flow, y, size);
            break;
        case DisturbanceKind::offset:
            y[0] = size;
            break;
        case DisturbanceKind::state:
            balance(flow.V0, flow.steady_friction + size);
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

FlowVector disturbed(const ChainFlow& flow, const SlowMode& mode, DisturbanceKind kind, double size)
{
    FlowVector y = flow.steady();
    const int n = flow.bodies, link = flow.link();
    const auto& b = flow.body[link];
    const double per_speed = b.logarithmic ? 1 / b.speed : 1;
    const auto along_mode = [&](int component, double amount) {
        y += (mode.right * (amount / mode.right[component])).real();
    };
    switch (kind) {
        case DisturbanceKind::position:
            along_mode(link, size);
            break;
        case DisturbanceKind::velocity:
            along_mode(n + link, size * per_speed);
            break;
        case DisturbanceKind::impulse:
            push(flow, y, size);
            break;
        case DisturbanceKind::offset:
            y.head(n).array() += size;
            break;
        case DisturbanceKind::state: {
            const FlowVector scale = flow.scale();
            set_friction(b.friction, b.ratio * b.speed, b.steady_friction + size, scale.data() + b.first_state,
                         y.data() + b.first_state);
            break;
        }
        case DisturbanceKind::start:
            return flow.slow_start(size);
    }
    return y;
}

}  // namespace stickslip
