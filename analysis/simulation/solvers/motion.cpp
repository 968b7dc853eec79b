// In one file: one motion with stick and slip: its events and limits hold only together.
#include "analysis/simulation/solvers/motion.h"

#include "analysis/base/work_limits.h"
#include "analysis/numerics/hermite.h"
#include "analysis/numerics/root.h"
#include "analysis/simulation/flows/break_away.h"
#include "analysis/simulation/flows/late_flow.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip {
namespace {

/// Share of V_0 beyond which a negative velocity is reverse sliding rather than the error of a step that ends at rest.
constexpr double reversal = 1e-6;

/// Share by which the speed at the event `slow` may miss near_rest: what a root in time leaves of a steep speed.
constexpr double slow_event = 1e-3;

constexpr double at_rest_speed = 1e-9;  ///< share of V_0 to which an event finds rest

/// A solver whose tolerance of V outweighs the first acceleration of a mass that breaks away puts it back to rest: each
/// such bounce lets the spring wind up by so much more before the next try.
constexpr double excess_growth = 4, largest_excess = 1e-6;

constexpr int most_idle_switches = 100;  ///< of bodies that stop and go without time moving on

/// Speed from which a solver resolves a singular friction, in units of V_0 times its tolerance, and at most of V_0:
/// less than near_rest.
constexpr double resolved = 1e4, largest_launch = 1e-3;
static_assert(largest_launch < near_rest);

/// Steps shorter than this share of the solver's clock start it anew: a slip after hours of creep lasts microseconds.
constexpr double resolved_step = 1e-9;

/// Steps that a fresh start gets to leave what stopped the one before: the rest of a step that an event cut is short,
/// too.
constexpr int settled_steps = 20;

/// Fresh starts after failures, with less than settled_steps between them, before the other solver has its try: where
/// the speed stands on the section to the last bit, CVODE's search for roots finds the same one for ever.
constexpr int most_restarts = 5;

constexpr double may_touch = 1;        ///< an event value that is larger at both ends of a step does not vanish between
constexpr double slope_share = 1e-3;   ///< of a step, over which the slope of an event at its ends is measured
constexpr double touch_width = 1e-12;  ///< of a step, to which the instant of a touch is located

}  // namespace
SlidingMotion::SlidingMotion(const Flow& flow, Solver solver, double rtol)
    : flow_(flow.copy()), solver_(solver), rtol_(rtol)
{
    late_ = dynamic_cast<LateFlow*>(flow_.get());
    if (late_) solver_ = Solver::rodas5p;
    stepper_ = stepper(solver_, rtol_);
    auto* sliding = dynamic_cast<SlidingFlow*>(flow_.get());
    if (sliding && sliding->can_rest()) mutable_flow_ = sliding;
    switching_ = dynamic_cast<SwitchingFlow*>(flow_.get());
    events_.count = mutable_flow_ ? 3 : switching_ ? 2 + switching_->switches() : 2;
    if (mutable_flow_) {  // V may vanish and reverse: straight measures
        events_.values = [this](const FlowVector& y, double* values) {
            const double speed = flow_->velocity(y) / flow_->commanded_velocity();
            values[section] = speed - 1;
            values[slow] = speed - near_rest;
            values[rest] = speed;
        };
    } else {
        const double threshold = flow_->logarithmic_speed() ? std::log(near_rest) : near_rest - 1;
        events_.values = [this, threshold](const FlowVector& y, double* values) {
            values[section] = flow_->speed_measure(y);
            values[slow] = values[section] - threshold;
            if (switching_) switching_->switch_values(y, values + rest);
        };
    }
}

void SlidingMotion::start(const FlowVector& y, double t)
{
    y_ = y;
    t_ = t;
    rest_time_ = 0;
    release_position_ = missing;
    sticks_ = 0;
    stuck_ = became_slow_ = false;
    bounces_ = 0;
    release_excess_ = SlidingFlow::least_excess;
    stepper_ = stepper(solver_, rtol_);
    idle_switches_ = 0;
    if (late_) late_->begin(y_);
    if (switching_) switching_->enter(y_);
    if (mutable_flow_ && y_[1] == 0) {
        arrive_at_rest();
    } else {
        if (mutable_flow_) mutable_flow_->branch = y_[1] > 0 ? Branch::forward : Branch::reverse;
        restart();
    }
    tell();
}

void SlidingMotion::surround(double force, double normal_load)
{
    flow_->surround(force, normal_load);
    idle_switches_ = 0;
    if (stuck_) {
        arrive_at_rest();
    } else {
        if (switching_) switching_->enter(y_);
        if (late_) late_->note_kink(y_);
        restart();
    }
    tell();
}

void SlidingMotion::restart()
{
    clock_ = t_;
    steps_of_clock_ = 0;
    rate_known_ = false;
    stepper_->start(*flow_, 0, y_, events_);
}

void SlidingMotion::begin_slide(Branch branch)
{
    stuck_ = false;
    mutable_flow_->branch = branch;
    y_[1] = 0;
    const double speed = mutable_flow_->V0 * std::min(resolved * rtol_, largest_launch);
    const double V = branch == Branch::forward ? speed : -speed;
    if (const auto launch = break_away(*mutable_flow_, y_, V)) {
        t_ += launch->time;
        rest_time_ += launch->time;
        y_[0] = launch->x;
        y_[1] = V;
    }
    restart();
}

void SlidingMotion::arrive_at_rest()
{
    ++rests_;
    y_[1] = 0;
    if (++bounces_ > 1) release_excess_ = std::min(largest_excess, release_excess_ * excess_growth);
    const double needed = mutable_flow_->holding_force(y_[0]);
    if (std::abs(needed) < mutable_flow_->release_force(y_[0], release_excess_)) {
        stuck_ = true;
        ++sticks_;
    } else {
        begin_slide(needed > 0 ? Branch::forward : Branch::reverse);
    }
}

/// Sticking: x falls at V_0, so the force needed changes at k_p V_0 until it overcomes the static friction of one side.
bool SlidingMotion::stick(double t_end)
{
    const double needed = mutable_flow_->holding_force(y_[0]),
                 limit = mutable_flow_->release_force(y_[0], release_excess_);
    const double rise = mutable_flow_->k_p * mutable_flow_->V0;
    const double wait = rise > 0 ? (limit - needed) / rise : rise < 0 ? (-limit - needed) / rise : infinity;
    if (!(std::isfinite(wait)) && !std::isfinite(t_end)) return false;
    const double until = std::min(t_end, t_ + wait);
    y_[0] -= mutable_flow_->V0 * (until - t_);
    rest_time_ += until - t_;
    t_ = until;
    if (until < t_end) {
        release_position_ = y_[0];
        begin_slide(rise > 0 ? Branch::forward : Branch::reverse);
    }
    return true;
}

/// False where bodies stop and go for ever at one instant.
bool SlidingMotion::pass_switch(int which)
{
    switching_->pass(which, y_);
    if (switching_->anything_rests()) ++sticks_;
    restart();
    return ++idle_switches_ < most_idle_switches;
}

bool SlidingMotion::step_failed()
{
    if (t_ > clock_ && ++restarts_ <= most_restarts) {
        restart();
        return false;
    }
    return !fall_back();
}

bool SlidingMotion::fall_back()
{
    if (solver_ != Solver::cvode || used_fallback_) return false;
    used_fallback_ = true;
    solver_ = Solver::rodas5p;
    stepper_ = stepper(solver_, rtol_);
    restart();
    return true;
}

std::optional<SlidingMotion::Touch> SlidingMotion::touched(double from, const FlowVector& before) const
{
    const double to = stepper_->time(), h = to - from;
    using Values = std::array<double, max_events>;
    const auto values = [&](const FlowVector& y) {
        Values v{};
        events_.values(y, v.data());
        return v;
    };
    const Values first = values(before), last = values(y_);
    std::optional<Touch> earliest;
    std::optional<Values> after_first, before_last;
    for (int i = rest; i < events_.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!(first[k] * last[k] > 0 && std::min(std::abs(first[k]), std::abs(last[k])) < may_touch)) continue;
        if (!after_first) {
            after_first = values(stepper_->at(from + slope_share * h));
            before_last = values(stepper_->at(to - slope_share * h));
        }
        const double s0 = ((*after_first)[k] - first[k]) / (slope_share * h);
        const double s1 = (last[k] - (*before_last)[k]) / (slope_share * h);
        if (!(s0 * first[k] < 0)) continue;
        const auto xi = hermite_turning(first[k], last[k], s0, s1, h);
        const auto value_at = [&](double t) { return values(stepper_->at(t))[k]; };
        if (!xi || value_at(from + *xi * h) * first[k] > 0) continue;
        const double turning = from + *xi * h;
        const auto root =
            bracketed_root(value_at, from, first[k], turning, value_at(turning), 0, touch_width * (turning - from));
        if (!earliest || root.high < earliest->time) earliest = {i, root.high};
    }
    return earliest;
}

void SlidingMotion::measure_step(double from, double to, const FlowVector& before, const StepReport& report, Turn& turn)
{
    const double V0 = flow_->commanded_velocity();
    double V = flow_->velocity(y_);
    if (switching_ && std::abs(V) < at_rest_speed * V0) V = 0;  // where the link's switch lies
    turn.velocity_min = std::min(turn.velocity_min, V);
    turn.velocity_max = std::max(turn.velocity_max, V);
    turn.position_min = std::min(turn.position_min, flow_->position(y_));
    turn.position_max = std::max(turn.position_max, flow_->position(y_));
    FlowVector r0 = rate_known_ ? rate_ : FlowVector(), r1;
    if (!rate_known_) flow_->rate(before, r0);
    flow_->rate(y_, r1);
    rate_ = r1;
    rate_known_ = !late_;  // its rate at one instant depends on the piece of its past
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
    const bool begins_slow = became_slow_ || is_slow(flow_->velocity(before));
    if (begins_slow && (is_slow(V) || (slow_event_here && report.direction > 0))) rest_time_ += h;
    became_slow_ = slow_event_here && report.direction < 0;
    if (V < -reversal * V0) turn.reversed = true;
    if (std::abs(V) > near_rest * V0) bounces_ = 0, release_excess_ = SlidingFlow::least_excess;
}

void SlidingMotion::tell()
{
    if (observer_) observer_({t_, y_, stuck_ ? 0.0 : flow_->velocity(y_), stuck_, *flow_});
}

Turn SlidingMotion::turn(double t_end, const std::function<bool(const FlowVector&)>& settled)
{
    steps_left_ = work::steps_of_turn;
    patience_left_ = work::multistep_steps_of_turn;
    return run(t_end, settled);
}

// In one piece: one turn: integrate, find the event, change the regime.
Turn SlidingMotion::run(double t_end, const std::function<bool(const FlowVector&)>& settled)
{
    Turn turn;
    turn.t0 = t_;
    turn.start = y_;
    turn.velocity_min = turn.velocity_max = stuck_ ? 0 : flow_->velocity(y_);
    turn.position_min = turn.position_max = flow_->position(y_);
    rest_time_ = 0;
    rests_ = 0;
    sticks_ = stuck_ || (switching_ && switching_->anything_rests()) ? 1 : 0;
    release_position_ = missing;
    const auto finish = [&](Turn::End end) {
        turn.end = end;
        turn.t1 = t_;
        turn.state = y_;
        turn.rest_time = rest_time_;
        turn.sticks = sticks_;
        turn.release_position = release_position_;
        return turn;
    };
    for (;;) {
        if (rests_ > work::rests_of_turn || --steps_left_ < 0) return finish(Turn::End::failure);
        if (--patience_left_ < 0 && !stuck_) fall_back();
        if (stuck_) {
            if (!stick(t_end)) return finish(Turn::End::held);
            turn.position_min = std::min(turn.position_min, y_[0]);
            turn.velocity_min = std::min(turn.velocity_min, 0.0);
            tell();
            if (t_ >= t_end) return finish(Turn::End::time);
            continue;
        }
        const double from = stepper_->time();
        const FlowVector before = y_;
        const double limit = late_ ? std::min(t_end, t_ + late_->step_limit(y_) - late_->clock(y_)) : t_end;
        ++turn.steps;
        auto report = stepper_->step(limit - clock_);
        if (report.end == StepEnd::failure) {
            if (step_failed()) return finish(Turn::End::failure);
            continue;
        }
        t_ = report.end == StepEnd::time ? limit : clock_ + stepper_->time();
        y_ = stepper_->state();
        double to = stepper_->time();
        const auto touch = to > from ? touched(from, before) : std::nullopt;
        if (touch && touch->time < to) {
            report = {StepEnd::event, touch->event, -1};
            to = touch->time, t_ = clock_ + to, y_ = stepper_->at(to);
        }
        if (late_) late_->remember(before, y_, [&](double f) { return stepper_->at(from + f * (to - from)); });
        if (to > from) idle_switches_ = 0;
        if (steps_of_clock_ > settled_steps) restarts_ = 0;
        const bool at_rest = mutable_flow_ && report.end == StepEnd::event && report.event == rest;
        if (at_rest) y_[1] = 0;
        measure_step(from, to, before, report, turn);
        const bool switched = switching_ && report.end == StepEnd::event && report.event >= rest;
        if (at_rest)
            arrive_at_rest();
        else if (switched && !pass_switch(report.event - rest))
            return finish(Turn::End::failure);
        else if (!switched && ++steps_of_clock_ > settled_steps && to - from < resolved_step * from)
            restart();
        tell();
        if (report.end == StepEnd::event && report.event == section && report.direction < 0)
            return finish(Turn::End::crossing);
        if (report.end == StepEnd::time && t_ >= t_end) return finish(Turn::End::time);
        if (settled && !stuck_ && settled(y_)) return finish(Turn::End::settled);
    }
}

bool SlidingMotion::advance(double t_end, int most_steps)
{
    steps_left_ = patience_left_ = most_steps;
    while (t_ < t_end) {
        const auto end = run(t_end, {}).end;
        if (end == Turn::End::failure || end == Turn::End::held) return false;
    }
    return true;
}

}  // namespace stickslip
