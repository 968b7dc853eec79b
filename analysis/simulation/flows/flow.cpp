// The flow of one body with inertia, and the joints that have one.
#include "analysis/simulation/flows/flow.h"

#include "analysis/stability/linear_joint.h"
#include "analysis/stability/steady.h"

#include <algorithm>

namespace stickslip {
namespace {

constexpr double least_change = 1e-6;  ///< of a state by a relative change of V of order one, per its level

/// Part of A that inertia takes at the creep speed, and the least and largest such speed per V_0: no solver resolves
/// smaller ones, and what a mass creeps at larger ones is no rest.
constexpr double inertial_part = 0.1, least_creep = 1e-7, largest_creep = 1e-5;

}  // namespace

bool has_unsteady_terms(const Friction& f, const Load& l)
{
    return f.level_moves() || l.gravity_amplitude != 0 || l.cogging.acts() || l.disturbance.amplitude != 0;
}

bool can_rest(const Friction& friction)
{
    const bool contact = friction.has_memory() && friction.memory.A > 0;
    return info(friction.law).set_valued_at_rest && !contact && !friction.has_bristle();
}

FrictionResponse respond_on(const Friction& friction, Branch branch, double V, double V0, const States& theta)
{
    const double edge = branch == Branch::forward ? rest_speed * V0 : -rest_speed * V0;
    if ((V - edge) * edge > 0) return respond(friction, V, theta);
    auto r = respond(friction, edge, theta);
    r.force += r.by_velocity * (V - edge);
    return r;
}

FrictionResponse respond_logarithmic(const Friction& friction, double w, double V0, const States& theta)
{
    const double V = V0 * std::exp(std::max(w, least_logarithm));
    auto r = respond(friction, V, theta);
    if (w < least_logarithm) r.force += r.by_velocity * V * (w - least_logarithm);
    return r;
}

double creep_speed(const DirectContact& contact, double stiffness, double inertia, double V0)
{
    const double unit = std::pow(contact.A / V0, 2) / (std::abs(stiffness) * inertia);
    return V0 * std::clamp(inertial_part * unit, least_creep, largest_creep);
}

FlowVector SlidingFlow::steady() const
{
    FlowVector y = FlowVector::Zero(size());
    y[1] = logarithmic ? 0 : V0;
    const auto theta = steady_state(friction, V0);
    for (int i = 0; i < states; ++i) y[2 + i] = theta[i];
    return y;
}

FlowVector SlidingFlow::scale() const
{
    FlowVector s(size());
    const auto r = respond(friction, V0, steady_state(friction, V0));
    // the offset at which the spring takes what a relative change of speed of order one takes
    double effort = std::abs(r.by_velocity) * V0 + k_v * V0 + std::sqrt(std::abs(k_p) * inertia) * V0;
    for (int i = 0; i < states; ++i) {
        const double change = std::abs(r.rate_by_velocity[i] * V0 / r.rate_by_state[i]);
        const double level = std::abs(steady_state(friction, V0)[i]);
        // a state that hardly depends on V there still has its level: rounding moves it by more than its change
        s[2 + i] = change > least_change * level && std::isfinite(change) ? change : std::max(level, 1e-300);
        effort += std::abs(r.by_state[i]) * s[2 + i];
    }
    s[0] = k_p != 0 ? effort / std::abs(k_p) : V0;
    s[1] = logarithmic ? 1 : V0;
    return s;
}

States SlidingFlow::states_of(const FlowVector& y) const
{
    States theta{};
    for (int i = 0; i < states; ++i) theta[i] = y[2 + i];
    return theta;
}

FrictionResponse SlidingFlow::response(const FlowVector& y) const
{
    const States theta = states_of(y);
    if (logarithmic) return respond_logarithmic(friction, y[1], V0, theta);
    if (steep()) return respond_on(friction, branch, y[1], creep_edge * creep / rest_speed, theta);
    return can_rest() ? respond_on(friction, branch, y[1], V0, theta) : respond(friction, y[1], theta);
}

void SlidingFlow::rate(const FlowVector& y, FlowVector& out) const
{
    const auto r = response(y);
    const double V = velocity(y);
    const double acceleration = (steady_friction + force - r.force - k_v * (V - V0) - k_p * y[0]) / inertia;
    out.resize(size());
    out[0] = logarithmic ? V0 * std::expm1(y[1]) : V - V0;
    out[1] = logarithmic ? acceleration / V : acceleration;
    for (int i = 0; i < states; ++i) out[2 + i] = r.rate[i];
}

void SlidingFlow::jacobian(const FlowVector& y, FlowMatrix& J) const
{
    const auto r = response(y);
    const double V = velocity(y);
    const double acceleration = (steady_friction + force - r.force - k_v * (V - V0) - k_p * y[0]) / inertia;
    const double per_speed = logarithmic ? 1 / V : 1;  // d y[1] / dV
    J.setZero(size(), size());
    J(0, 1) = 1 / per_speed;
    J(1, 0) = -k_p / inertia * per_speed;
    J(1, 1) = -(k_v + r.by_velocity) / inertia - (logarithmic && y[1] > least_logarithm ? acceleration / V : 0);
    for (int i = 0; i < states; ++i) {
        J(1, 2 + i) = -r.by_state[i] / inertia * per_speed;
        J(2 + i, 1) = r.rate_by_velocity[i] / per_speed;
        J(2 + i, 2 + i) = r.rate_by_state[i];
    }
}

FlowVector SlidingFlow::speed_gradient(const FlowVector&) const
{
    FlowVector g = FlowVector::Zero(size());
    g[1] = logarithmic ? 1 : 1 / V0;
    return g;
}

std::unique_ptr<Flow> SlidingFlow::with_gain(double gain) const
{
    auto copy = std::make_unique<SlidingFlow>(*this);
    copy->k_p = gain;
    return copy;
}

double SlidingFlow::release_force(const FlowVector& y, Branch direction, double excess) const
{
    const double forces = std::abs(steady_friction) + std::abs(force) + std::abs(k_v * V0) + std::abs(k_p * y[0]);
    const double V = direction == Branch::forward ? creep : -creep;
    const double held = steep() ? std::abs(respond(friction, V, states_of(y)).force) : static_force();
    return held + excess * forces;
}

double SlidingFlow::wind_up_time() const
{
    return 2 * (steep() ? std::abs(steady_friction) : static_force()) / (std::abs(k_p) * V0);
}

double SlidingFlow::static_force() const
{
    return stickslip::static_force(friction);
}

SlidingOrReason sliding_flow(const Joint& joint)
{
    SlidingOrReason result;
    auto& flow = result.flow;
    if (joint.mechanism.model != Model::single_mass || has_unsteady_terms(joint.friction, joint.load) ||
        joint.normal.moves() || joint.neighbour.size > 0) {
        result.reason = Reason::unsupported;
        return result;
    }
    const auto sliding = steady_sliding(joint);
    result.reason = sliding.reason;
    if (result.reason != Reason::none) return result;
    if (info(joint.friction.law).needs_history) result.reason = Reason::unsupported;
    if (info(joint.friction.law).linear_only) result.reason = Reason::linear_only;
    if (result.reason != Reason::none) return result;
    flow.inertia = joint.mechanism.inertia;
    const auto loop = linear_joint(joint, sliding.slides_at);
    flow.k_v = loop.k_v * loop.actuated[0];
    flow.k_p = loop.k_p * loop.actuated[0] + loop.contact[0];
    flow.friction = joint.friction;
    flow.V0 = std::abs(sliding.slides_at);
    if (sliding.slides_at < 0) {
        flow.friction.asymmetry.coulomb *= -1;
        flow.friction.asymmetry.viscous *= -1;
    }
    flow.steady_friction = steady_force(flow.friction, flow.V0);
    flow.logarithmic = info(joint.friction.law).needs_motion;
    flow.states = states(flow.friction);
    const auto contact = direct_contact(flow.friction, flow.V0);
    if (is_steep(contact, flow.V0)) flow.creep = creep_speed(contact, flow.k_p, flow.inertia, flow.V0);
    if (!flow.steady().allFinite() || !flow.scale().allFinite()) result.reason = Reason::not_finite;
    return result;
}

}  // namespace stickslip
