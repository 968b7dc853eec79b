#include "analysis/simulation/flows/delayed_flow.h"

#include "analysis/stability/linear_joint.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

DelayedFlow::DelayedFlow(ChainFlow chain) : V0(chain.V0), chain_(std::move(chain))
{
    for (int i = 0; i < chain_.bodies; ++i) {
        const auto& b = chain_.body[i];
        if (!b.delayed) continue;
        past_.set_lag(i, std::get<TimeLag>(b.friction.law).lag);
    }
    past_.begin(0, steady_speeds());
}

FlowVector DelayedFlow::with_clock(const FlowVector& y, double clock) const
{
    FlowVector longer(size());
    longer << y, clock;
    return longer;
}

PastSpeeds::Speeds DelayedFlow::steady_speeds() const
{
    PastSpeeds::Speeds speeds{};
    for (int i = 0; i < chain_.bodies; ++i) speeds[i] = chain_.body[i].speed;
    return speeds;
}

DelayedForces DelayedFlow::friction_at(double clock) const
{
    DelayedForces delayed{};
    for (int i = 0; i < chain_.bodies; ++i) {
        const auto& b = chain_.body[i];
        if (!b.delayed) continue;
        const double V = b.ratio * std::max(std::abs(past_.then(i, clock).value), rest_speed * b.speed);
        delayed[i] = delayed_force(b.friction, V, b.mode == ChainFlow::Mode::reverse);
    }
    return delayed;
}

DelayedForces DelayedFlow::friction_rate_at(double clock) const
{
    DelayedForces change{};
    for (int i = 0; i < chain_.bodies; ++i) {
        const auto& b = chain_.body[i];
        if (!b.delayed) continue;
        const auto then = past_.then(i, clock);
        const double V = b.ratio * std::abs(then.value);
        if (!(V > rest_speed * b.ratio * b.speed)) continue;
        const double slope = delayed_slope(b.friction, V, b.mode == ChainFlow::Mode::reverse);
        change[i] = slope * b.ratio * std::copysign(then.slope, then.slope * then.value);
    }
    return change;
}

void DelayedFlow::rate(const FlowVector& y, FlowVector& out) const
{
    chain_.rate(y, friction_at(clock(y)), out);
    out = with_clock(FlowVector(out), 1);
}

void DelayedFlow::jacobian(const FlowVector& y, FlowMatrix& J) const
{
    const int n = chain_.size();
    FlowMatrix of_chain;
    chain_.jacobian(y, of_chain);
    J.setZero(n + 1, n + 1);
    J.topLeftCorner(n, n) = of_chain;
    const auto change = friction_rate_at(clock(y));
    for (int i = 0; i < chain_.bodies; ++i) {
        const auto& b = chain_.body[i];
        if (b.mode != ChainFlow::Mode::stuck) J(chain_.bodies + i, n) = -b.ratio * change[i] / b.inertia;
    }
}

std::unique_ptr<Flow> DelayedFlow::with_gain(double k_p) const
{
    auto copy = std::make_unique<DelayedFlow>(*this);
    copy->chain_.loop.k_p = k_p;
    return copy;
}

void DelayedFlow::switch_values(const FlowVector& y, double* values) const
{
    chain_.switch_values(y, friction_at(clock(y)), values);
}

void DelayedFlow::enter(FlowVector& y)
{
    chain_.enter(y, friction_at(clock(y)));
}

void DelayedFlow::pass(int which, FlowVector& y)
{
    chain_.pass(which, y, friction_at(clock(y)));
    note_kink(y);
}

void DelayedFlow::begin(FlowVector& y)
{
    y[chain_.size()] = 0;
    past_.begin(0, steady_speeds());
}

double DelayedFlow::step_limit(const FlowVector& y)
{
    std::array<bool, max_bodies> rests{};
    for (int i = 0; i < chain_.bodies; ++i) rests[i] = chain_.body[i].mode == ChainFlow::Mode::stuck;
    return past_.step_limit(clock(y), rests);
}

double DelayedFlow::delayed_rate(int i) const
{
    const auto& b = chain_.body[i];
    return -b.ratio * b.ratio * delayed_slope(b.friction, b.ratio * b.speed, false) / b.inertia;
}

bool has_delayed_friction(const Joint& joint)
{
    const auto chain = chain_of(joint);
    return std::any_of(chain.body.begin(), chain.body.begin() + chain.bodies,
                       [](const Body& b) { return std::holds_alternative<TimeLag>(b.friction->law); });
}

Detail why_no_flow(const Joint& joint)
{
    if (has_delayed_friction(joint)) return Detail::late_with_memory;
    if (joint.normal.moves()) return Detail::moving_normal_load;
    if (joint.neighbour.size > 0) return Detail::neighbours;
    const auto& m = joint.mechanism;
    if (m.transmission.backlash + m.motor_transmission.backlash + m.transmission_link.backlash > 0)
        return Detail::backlash;
    return Detail::place_or_time;
}

DelayedOrReason delayed_flow(const Joint& joint)
{
    auto chain = chain_flow(joint, true);
    return {DelayedFlow(std::move(chain.flow)), chain.reason};
}

}  // namespace stickslip
