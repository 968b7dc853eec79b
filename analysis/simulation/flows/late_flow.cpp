#include "analysis/simulation/flows/late_flow.h"

#include "analysis/stability/linear_joint.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Share of the time between kinks by which the side of a kink is decided.
constexpr double beside = 1e-9;

/// What rounding leaves of a step is none: per lag, and per time.
constexpr double passed_of_lag = 1e-12, passed_of_time = 1e-14;

/// A lag after a kink the velocity's derivative has it, one order higher each further lag: then it lies beyond the
/// order of the method.
constexpr int felt_lags = 4;

/// Friction of the other direction under an asymmetry: f − 2 of this.
double both_ways(const Friction& friction, double V)
{
    return friction.normal_load * (friction.asymmetry.coulomb + friction.asymmetry.viscous * V);
}

}  // namespace

LateFlow::LateFlow(ChainFlow chain) : V0(chain.V0), chain_(std::move(chain))
{
    for (int i = 0; i < chain_.bodies; ++i) {
        const auto& b = chain_.body[i];
        if (!b.late) continue;
        lag_[i] = std::get<TimeLag>(b.friction.law).lag;
        shortest_lag_ = std::min(shortest_lag_, lag_[i]);
        longest_lag_ = std::max(longest_lag_, lag_[i]);
        history_[i].start(b.speed);
    }
}

FlowVector LateFlow::with_clock(const FlowVector& y, double clock) const
{
    FlowVector longer(size());
    longer << y, clock;
    return longer;
}

SpeedHistory::Speed LateFlow::speed_then(int i, double clock) const
{
    const double margin = beside * std::min(piece_to_ - piece_from_, lag_[i]);
    const double pick = std::clamp(clock, piece_from_ + margin, piece_to_ - margin);
    return history_[i].at(clock - lag_[i], pick - lag_[i]);
}

LateFriction LateFlow::friction_at(double clock) const
{
    LateFriction late{};
    for (int i = 0; i < chain_.bodies; ++i) {
        const auto& b = chain_.body[i];
        if (!b.late) continue;
        const double V = b.ratio * std::max(std::abs(speed_then(i, clock).value), rest_speed * b.speed);
        const double forward = steady_force(b.friction, V);
        late[i] = b.mode == ChainFlow::Mode::reverse ? 2 * both_ways(b.friction, V) - forward : forward;
    }
    return late;
}

double LateFlow::slope(int i, double V) const
{
    const auto& f = chain_.body[i].friction;
    return f.normal_load * (steady_slope(std::get<TimeLag>(f.law).curve.law, V) + f.asymmetry.viscous);
}

LateFriction LateFlow::friction_rate_at(double clock) const
{
    LateFriction change{};
    for (int i = 0; i < chain_.bodies; ++i) {
        const auto& b = chain_.body[i];
        if (!b.late) continue;
        const auto then = speed_then(i, clock);
        const double V = b.ratio * std::abs(then.value);
        if (!(V > rest_speed * b.ratio * b.speed)) continue;
        const bool reverse = b.mode == ChainFlow::Mode::reverse;
        const double viscous = reverse ? 2 * b.friction.normal_load * b.friction.asymmetry.viscous : 0;
        const double of_speed = reverse ? viscous - slope(i, V) : slope(i, V);
        change[i] = of_speed * b.ratio * std::copysign(then.slope, then.slope * then.value);
    }
    return change;
}

void LateFlow::rate(const FlowVector& y, FlowVector& out) const
{
    chain_.rate(y, friction_at(clock(y)), out);
    out = with_clock(FlowVector(out), 1);
}

void LateFlow::jacobian(const FlowVector& y, FlowMatrix& J) const
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

std::unique_ptr<Flow> LateFlow::with_gain(double k_p) const
{
    auto copy = std::make_unique<LateFlow>(*this);
    copy->chain_.loop.k_p = k_p;
    return copy;
}

void LateFlow::switch_values(const FlowVector& y, double* values) const
{
    chain_.switch_values(y, friction_at(clock(y)), values);
}

void LateFlow::enter(FlowVector& y)
{
    chain_.enter(y, friction_at(clock(y)));
}

void LateFlow::pass(int which, FlowVector& y)
{
    chain_.pass(which, y, friction_at(clock(y)));
    note_kink(y);
}

void LateFlow::begin(FlowVector& y)
{
    y[chain_.size()] = 0;
    for (int i = 0; i < chain_.bodies; ++i) history_[i].start(chain_.body[i].speed);
    kinks_.clear();
    piece_from_ = 0;
    piece_to_ = infinity;
    note_kink(y);
}

void LateFlow::note_kink(const FlowVector& y)
{
    for (const double lag : lag_)
        for (int k = 1; lag > 0 && k <= felt_lags; ++k) kinks_.insert(clock(y) + k * lag);
}

double LateFlow::step_limit(const FlowVector& y)
{
    const double now = clock(y), passed = now + std::max(passed_of_lag * shortest_lag_, passed_of_time * now);
    while (!kinks_.empty() && *kinks_.begin() <= passed) {
        piece_from_ = *kinks_.begin();
        kinks_.erase(kinks_.begin());
    }
    piece_to_ = kinks_.empty() ? infinity : *kinks_.begin();
    double reach = infinity;  // a body at rest needs no past
    for (int i = 0; i < chain_.bodies; ++i)
        if (chain_.body[i].late && chain_.body[i].mode != ChainFlow::Mode::stuck) reach = std::min(reach, lag_[i]);
    return std::min(now + reach, piece_to_);
}

double LateFlow::late_rate(int i) const
{
    const auto& b = chain_.body[i];
    return -b.ratio * b.ratio * slope(i, b.ratio * b.speed) / b.inertia;
}

bool answers_late(const Joint& joint)
{
    const auto chain = chain_of(joint);
    return std::any_of(chain.body.begin(), chain.body.begin() + chain.bodies,
                       [](const Body& b) { return std::holds_alternative<TimeLag>(b.friction->law); });
}

LateOrReason late_flow(const Joint& joint)
{
    auto chain = chain_flow(joint, true);
    return {LateFlow(std::move(chain.flow)), chain.reason};
}

}  // namespace stickslip
