// What a turn measures as its motion goes on: extremes of speed and position, time at rest, stops.
#include "analysis/simulation/solvers/motion.h"

#include "analysis/numerics/hermite.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Share of V_0 beyond which a negative velocity is reverse sliding rather than the error of a step that ends at rest.
constexpr double reversal = 1e-6;

/// Share by which the speed at the event `slow` may miss near_rest: what a root in time leaves of a steep speed.
constexpr double slow_event = 1e-3;

constexpr double at_rest_speed = 1e-9;  ///< share of V_0 to which an event finds rest

}  // namespace

Turn SlidingMotion::begun_turn()
{
    Turn turn;
    turn.t0 = t_;
    turn.start = y_;
    turn.velocity_min = turn.velocity_max = rest_.stuck ? 0 : flow_->velocity(y_);
    turn.position_min = turn.position_max = flow_->position(y_);
    rest_.time = 0;
    rest_.rests = 0;
    rest_.sticks = rest_.stuck || (as_.switching && as_.switching->anything_rests()) ? 1 : 0;
    rest_.released_at = missing;
    return turn;
}

void SlidingMotion::measure_step(double from, double to, const FlowVector& before, const StepReport& report, Turn& turn)
{
    const double V0 = flow_->commanded_velocity();
    double V = flow_->velocity(y_);
    if (as_.switching && std::abs(V) < at_rest_speed * V0) V = 0;  // where the link's switch lies
    turn.velocity_min = std::min(turn.velocity_min, V);
    turn.velocity_max = std::max(turn.velocity_max, V);
    turn.position_min = std::min(turn.position_min, flow_->position(y_));
    turn.position_max = std::max(turn.position_max, flow_->position(y_));
    FlowVector r0 = rate_known_ ? rate_ : FlowVector(), r1;
    if (!rate_known_) flow_->rate(before, r0);
    flow_->rate(y_, r1);
    rate_ = r1;
    rate_known_ = !as_.delayed;  // its rate at one instant depends on the piece of its past
    const double h = to - from;
    const double m0 = flow_->speed_measure(before), m1 = flow_->speed_measure(y_);
    const double s0 = flow_->speed_gradient(before).dot(r0), s1 = flow_->speed_gradient(y_).dot(r1);
    // the slopes of a stiff motion are no better than its tolerance times its stiffness: good enough to say where
    if (const auto xi = hermite_turning(m0, m1, s0, s1, h)) {
        const double peak = flow_->velocity(stepper_->at(from + *xi * h));
        turn.velocity_min = std::min(turn.velocity_min, peak);
        turn.velocity_max = std::max(turn.velocity_max, peak);
    }
    // an event knows that the speed passed near_rest even where the root in time leaves a steep speed far from it
    const auto is_slow = [V0](double speed) { return speed <= near_rest * V0 * (1 + slow_event); };
    const bool slow_event_here = report.end == StepEnd::event && report.event == slow;
    const bool begins_slow = rest_.became_slow || is_slow(flow_->velocity(before));
    if (begins_slow && (is_slow(V) || (slow_event_here && report.direction > 0))) rest_.time += h;
    rest_.became_slow = slow_event_here && report.direction < 0;
    if (V < -reversal * V0) turn.reversed = true;
    if (std::abs(V) > near_rest * V0) rest_.bounces = 0, rest_.release_excess = SlidingFlow::least_excess;
}

Turn SlidingMotion::finished(Turn turn, Turn::End end) const
{
    turn.end = end;
    turn.t1 = t_;
    // what rounding leaves of a rest is no motion backwards
    if (turn.velocity_min < 0 && turn.velocity_min > -rest_speed * flow_->commanded_velocity()) turn.velocity_min = 0;
    turn.state = y_;
    turn.rest_time = rest_.time;
    turn.sticks = rest_.sticks;
    turn.release_position = rest_.released_at;
    return turn;
}

}  // namespace stickslip
