// The equations of motion of a chain of bodies, and where it stands in balance.
#include "analysis/simulation/flows/chain_flow.h"

#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Share of the static friction that a body carries when its joint starts from rest: that it moves must be an event.
constexpr double almost_released = 0.999;

}  // namespace

FlowVector ChainFlow::steady() const
{
    FlowVector y = FlowVector::Zero(size());
    for (int i = 0; i < bodies; ++i) {
        const auto& b = body[i];
        y[bodies + i] = b.logarithmic ? 0 : b.speed;
        const auto theta = steady_state(b.friction, b.ratio * b.speed);
        std::copy_n(theta.begin(), b.states, y.data() + b.first_state);
    }
    return y;
}

FlowVector ChainFlow::scale() const
{
    FlowVector s(size());
    double effort = 0, inertia = 0;
    for (int i = 0; i < bodies; ++i) {
        const auto& b = body[i];
        const double V = b.ratio * b.speed;
        const auto theta = steady_state(b.friction, V);
        const auto r = respond(b.friction, V, theta);
        effort += b.ratio * std::abs(r.by_velocity) * V;
        inertia += b.inertia;
        s[bodies + i] = b.logarithmic ? 1 : b.speed;
        for (int j = 0; j < b.states; ++j) {
            const double change = std::abs(r.rate_by_velocity[j] * V / r.rate_by_state[j]);
            const double state = change > 0 && std::isfinite(change) ? change : std::max(std::abs(theta[j]), 1e-300);
            s[b.first_state + j] = state;
            effort += b.ratio * std::abs(r.by_state[j]) * state;
        }
    }
    effort += (loop.k_v + std::sqrt(std::abs(loop.k_p) * inertia)) * V0;
    // the displacement at which a body's springs take what a relative change of speed of order one takes
    for (int i = 0; i < bodies; ++i) s[i] = effort / std::abs(stiffness(i, i));
    return s;
}

double ChainFlow::velocity(const FlowVector& y, int i) const
{
    const auto& b = body[i];
    return b.logarithmic ? b.speed * std::exp(std::max(y[bodies + i], least_logarithm)) : y[bodies + i];
}

void ChainFlow::set_velocity(FlowVector& y, int i, double v) const
{
    y[bodies + i] = body[i].logarithmic ? std::log(v / body[i].speed) : v;
}

States ChainFlow::states_of(const FlowVector& y, int i) const
{
    States theta{};
    std::copy_n(y.data() + body[i].first_state, body[i].states, theta.begin());
    return theta;
}

double ChainFlow::static_force(int i) const
{
    const auto& b = body[i];
    const double at_rest = stickslip::static_force(b.friction);
    // a curve with a jump at V = 0 is set-valued there if it is delayed, whatever the law it is taken from
    return b.delayed ? std::max(at_rest, steady_force(b.friction, rest_speed * b.ratio * b.speed)) : at_rest;
}

FrictionResponse ChainFlow::response(const FlowVector& y, int i, const DelayedForces& delayed) const
{
    const auto& b = body[i];
    if (b.delayed) {
        FrictionResponse given;
        given.force = delayed[i];
        return given;
    }
    const double V = b.ratio * velocity(y, i);
    const auto theta = states_of(y, i);
    if (b.logarithmic) return respond_logarithmic(b.friction, y[bodies + i], b.ratio * b.speed, theta);
    if (!b.rests) return respond(b.friction, V, theta);
    const auto branch = b.mode == Mode::reverse ? Branch::reverse : Branch::forward;
    return respond_on(b.friction, branch, V, b.ratio * (b.creep > 0 ? creep_edge * b.creep / rest_speed : b.speed),
                      theta);
}

double ChainFlow::limit(const FlowVector& y, int i, double needed, const DelayedForces& delayed) const
{
    const auto& b = body[i];
    if (b.creep > 0)
        return b.ratio * std::abs(respond(b.friction, b.ratio * std::copysign(b.creep, needed), states_of(y, i)).force);
    return b.ratio * std::max(static_force(i), std::abs(delayed[i]));
}

double ChainFlow::needed(const FlowVector& y, int i) const
{
    double sum = body[i].ratio * body[i].steady_friction + (i == link() ? force : 0);
    for (int k = 0; k < bodies; ++k) sum -= stiffness(i, k) * y[k] + damping(i, k) * (velocity(y, k) - body[k].speed);
    return sum;
}

void ChainFlow::rate(const FlowVector& y, const DelayedForces& delayed, FlowVector& out) const
{
    out.setZero(size());
    for (int i = 0; i < bodies; ++i) {
        const auto& b = body[i];
        const auto r = response(y, i, delayed);
        for (int j = 0; j < b.states; ++j) out[b.first_state + j] = r.rate[j];
        if (b.mode == Mode::stuck) {
            out[i] = -b.speed;
            continue;
        }
        const double acceleration = (needed(y, i) - b.ratio * r.force) / b.inertia;
        out[i] = b.logarithmic ? b.speed * std::expm1(y[bodies + i]) : y[bodies + i] - b.speed;
        out[bodies + i] = b.logarithmic ? acceleration / velocity(y, i) : acceleration;
    }
}

void ChainFlow::jacobian(const FlowVector& y, FlowMatrix& J) const
{
    J.setZero(size(), size());
    for (int i = 0; i < bodies; ++i) {
        const auto& b = body[i];
        const auto r = response(y, i, {});
        const double v = velocity(y, i), own = b.ratio * (b.logarithmic ? v : 1);  // dV_i / ds_i
        for (int j = 0; j < b.states; ++j) {
            J(b.first_state + j, bodies + i) = r.rate_by_velocity[j] * own;
            J(b.first_state + j, b.first_state + j) = r.rate_by_state[j];
        }
        if (b.mode == Mode::stuck) continue;
        const double per_inertia = (b.logarithmic ? 1 / v : 1) / b.inertia;
        J(i, bodies + i) = b.logarithmic ? v : 1;
        for (int k = 0; k < bodies; ++k) {
            J(bodies + i, k) = -stiffness(i, k) * per_inertia;
            J(bodies + i, bodies + k) = -damping(i, k) * (body[k].logarithmic ? velocity(y, k) : 1) * per_inertia;
        }
        J(bodies + i, bodies + i) -= b.ratio * r.by_velocity * own * per_inertia;
        if (b.logarithmic && y[bodies + i] > least_logarithm)
            J(bodies + i, bodies + i) -= (needed(y, i) - b.ratio * r.force) * per_inertia;
        for (int j = 0; j < b.states; ++j) J(bodies + i, b.first_state + j) = -b.ratio * r.by_state[j] * per_inertia;
    }
}

double ChainFlow::speed_measure(const FlowVector& y) const
{
    const double s = y[bodies + link()];
    return body[link()].logarithmic ? s : s / V0 - 1;
}

FlowVector ChainFlow::speed_gradient(const FlowVector&) const
{
    FlowVector g = FlowVector::Zero(size());
    g[bodies + link()] = body[link()].logarithmic ? 1 : 1 / V0;
    return g;
}

std::unique_ptr<Flow> ChainFlow::with_gain(double k_p) const
{
    auto copy = std::make_unique<ChainFlow>(*this);
    copy->loop.k_p = k_p;
    return copy;
}

double ChainFlow::wind_up_time() const
{
    double held = 0, compliance = 1 / std::abs(loop.k_p);
    for (int i = 0; i < bodies; ++i)
        held += body[i].ratio * (body[i].creep > 0 ? std::abs(body[i].steady_friction) : static_force(i));
    for (int i = 1; i < bodies; ++i) compliance += 1 / std::abs(loop.stiffness_at(i - 1, i));
    return 2 * held * compliance / V0;
}

double ChainFlow::link_friction(const FlowVector& y, const DelayedForces& delayed) const
{
    return link_stuck() ? needed(y, link()) : response(y, link(), delayed).force;
}

FlowVector ChainFlow::slow_start(double share) const
{
    FlowVector y = steady();
    Eigen::MatrixXd K(bodies, bodies);
    Eigen::VectorXd carried(bodies);
    for (int i = 0; i < bodies; ++i) {
        const auto& b = body[i];
        const double v = b.rests && b.creep == 0 && share < 1e-3 ? 0 : std::max(share, 1e-12) * b.speed;
        set_velocity(y, i, v);
        const auto theta = steady_state(b.friction, b.ratio * v);
        std::copy_n(theta.begin(), b.states, y.data() + b.first_state);
        const double f = v == 0 ? almost_released * static_force(i) : respond(b.friction, b.ratio * v, theta).force;
        carried[i] = b.ratio * (b.steady_friction - f);
        for (int k = 0; k < bodies; ++k) K(i, k) = stiffness(i, k);
    }
    for (int i = 0; i < bodies; ++i)
        for (int k = 0; k < bodies; ++k) carried[i] -= damping(i, k) * (velocity(y, k) - body[k].speed);
    y.head(bodies) = K.partialPivLu().solve(carried);
    return y;
}

}  // namespace stickslip
