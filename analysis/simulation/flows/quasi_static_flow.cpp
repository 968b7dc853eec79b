// The flow of one body without inertia: its speed follows from the balance of forces.
#include "analysis/simulation/flows/flow.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

FlowVector QuasiStaticFlow::steady() const
{
    const FlowVector y = full_.steady();
    FlowVector reduced(size());
    reduced[0] = y[0];
    for (int i = 0; i < full_.states; ++i) reduced[1 + i] = y[2 + i];
    return reduced;
}

FlowVector QuasiStaticFlow::scale() const
{
    const FlowVector s = full_.scale();
    FlowVector reduced(size());
    reduced[0] = s[0];
    for (int i = 0; i < full_.states; ++i) reduced[1 + i] = s[2 + i];
    return reduced;
}

double QuasiStaticFlow::velocity(const FlowVector& y) const
{
    States theta{};
    for (int i = 0; i < full_.states; ++i) theta[i] = y[1 + i];
    const double needed = full_.steady_friction + full_.force - full_.k_p * y[0];
    // Newton in ln V: the balance is nearly linear there for every law with a direct effect
    double logarithm = 0;
    for (int i = 0; i < 100; ++i) {
        const double V = full_.V0 * std::exp(logarithm);
        const auto r = respond(full_.friction, V, theta);
        const double step = (r.force + full_.k_v * (V - full_.V0) - needed) / ((r.by_velocity + full_.k_v) * V);
        logarithm -= std::clamp(step, -5.0, 5.0);
        if (!(std::abs(step) > 1e-15 * (1 + std::abs(logarithm)))) break;
    }
    return full_.V0 * std::exp(logarithm);
}

void QuasiStaticFlow::rate(const FlowVector& y, FlowVector& out) const
{
    States theta{};
    for (int i = 0; i < full_.states; ++i) theta[i] = y[1 + i];
    const double V = velocity(y);
    const auto r = respond(full_.friction, V, theta);
    out.resize(size());
    out[0] = V - full_.V0;
    for (int i = 0; i < full_.states; ++i) out[1 + i] = r.rate[i];
}

void QuasiStaticFlow::jacobian(const FlowVector& y, FlowMatrix& J) const
{
    States theta{};
    for (int i = 0; i < full_.states; ++i) theta[i] = y[1 + i];
    const double V = velocity(y);
    const auto r = respond(full_.friction, V, theta);
    // the balance gives dV = −(k_p dx + Σ f_θ dθ)/(k_v + f_V)
    const double resistance = full_.k_v + r.by_velocity;
    FlowVector dV(size());
    dV[0] = -full_.k_p / resistance;
    for (int i = 0; i < full_.states; ++i) dV[1 + i] = -r.by_state[i] / resistance;
    J.setZero(size(), size());
    J.row(0) = dV.transpose();
    for (int i = 0; i < full_.states; ++i) {
        J.row(1 + i) = r.rate_by_velocity[i] * dV.transpose();
        J(1 + i, 1 + i) += r.rate_by_state[i];
    }
}

double QuasiStaticFlow::speed_measure(const FlowVector& y) const
{
    return std::log(velocity(y) / full_.V0);
}

FlowVector QuasiStaticFlow::speed_gradient(const FlowVector& y) const
{
    States theta{};
    for (int i = 0; i < full_.states; ++i) theta[i] = y[1 + i];
    const double V = velocity(y);
    const auto r = respond(full_.friction, V, theta);
    FlowVector g(size());
    g[0] = -full_.k_p;
    for (int i = 0; i < full_.states; ++i) g[1 + i] = -r.by_state[i];
    return g / ((full_.k_v + r.by_velocity) * V);
}

std::unique_ptr<Flow> QuasiStaticFlow::with_gain(double gain) const
{
    auto copy = std::make_unique<QuasiStaticFlow>(*this);
    copy->full_.k_p = gain;
    return copy;
}

}  // namespace stickslip
