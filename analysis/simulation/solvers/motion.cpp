// A motion from event to event: steps of a solver, and the regime that holds between them.
#include "analysis/simulation/solvers/motion.h"

#include "analysis/base/work_limits.h"
#include "analysis/simulation/flows/delayed_flow.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Steps shorter than this share of the solver's clock start it anew: a slip after hours of creep lasts microseconds.
constexpr double resolved_step = 1e-9;

/// Steps that a fresh start gets to leave what stopped the one before: the rest of a step that an event cut is short,
/// too.
constexpr int settled_steps = 20;

/// Fresh starts after failures, with less than settled_steps between them, before the other solver has its try: where
/// the speed stands on the section to the last bit, CVODE's search for roots finds the same one for ever.
constexpr int most_restarts = 5;

}  // namespace

SlidingMotion::Roles::Roles(Flow& flow)
    : switching(dynamic_cast<SwitchingFlow*>(&flow)), delayed(dynamic_cast<DelayedFlow*>(&flow))
{
    auto* sliding = dynamic_cast<SlidingFlow*>(&flow);
    if (sliding && sliding->sticks()) sticking = sliding;
}

SlidingMotion::SlidingMotion(const Flow& flow, Solver solver, double rtol)
    : flow_(flow.copy()),
      as_(*flow_),
      solver_(as_.delayed ? Solver::rodas5p : solver),
      rtol_(rtol),
      stepper_(stepper(solver_, rtol_))
{
    events_.count = as_.sticking ? 3 : as_.switching ? 2 + as_.switching->switches() : 2;
    if (as_.sticking) {  // V may vanish and reverse: straight measures
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
            if (as_.switching) as_.switching->switch_values(y, values + rest);
        };
    }
}

void SlidingMotion::start(const FlowVector& y, double t)
{
    y_ = y;
    t_ = t;
    rest_ = {};
    stepper_ = stepper(solver_, rtol_);
    effort_.idle_switches = 0;
    if (as_.delayed) as_.delayed->begin(y_);
    if (as_.switching) as_.switching->enter(y_);
    if (as_.sticking && y_[1] == 0) {
        arrive_at_rest();
    } else {
        if (as_.sticking) as_.sticking->branch = y_[1] > 0 ? Branch::forward : Branch::reverse;
        restart();
    }
    notify();
}

void SlidingMotion::surround(double force, double normal_load)
{
    flow_->surround(force, normal_load);
    effort_.idle_switches = 0;
    if (rest_.stuck) {
        arrive_at_rest();
    } else {
        if (as_.switching) as_.switching->enter(y_);
        if (as_.delayed) as_.delayed->note_kink(y_);
        restart();
    }
    notify();
}

void SlidingMotion::restart()
{
    clock_.zero = t_;
    clock_.steps = 0;
    rate_known_ = false;
    stepper_->start(*flow_, 0, y_, events_);
}

bool SlidingMotion::step_failed()
{
    if (t_ > clock_.zero && ++effort_.restarts <= most_restarts) {
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

void SlidingMotion::notify()
{
    if (observer_) observer_({t_, y_, rest_.stuck ? 0.0 : flow_->velocity(y_), rest_.stuck, *flow_});
}

Turn SlidingMotion::turn(double t_end, const std::function<bool(const FlowVector&)>& settled)
{
    effort_.steps_left = work::steps_of_turn;
    effort_.patience_left = work::multistep_steps_of_turn;
    return run(t_end, settled);
}

Turn SlidingMotion::run(double t_end, const std::function<bool(const FlowVector&)>& settled)
{
    Turn turn = begun_turn();
    for (;;) {
        if (rest_.rests > work::rests_of_turn || --effort_.steps_left < 0) return finished(turn, Turn::End::failure);
        if (--effort_.patience_left < 0 && !rest_.stuck) fall_back();
        if (rest_.stuck) {
            if (!stick(t_end)) return finished(turn, Turn::End::held);
            turn.position_min = std::min(turn.position_min, y_[0]);
            turn.velocity_min = std::min(turn.velocity_min, 0.0);
            notify();
            if (t_ >= t_end) return finished(turn, Turn::End::time);
        } else if (const auto end = slide(t_end, settled, turn)) {
            return finished(turn, *end);
        }
    }
}

/// One step of the solver, up to the event that ends it, and the change of the regime there; how the turn ends, if so.
std::optional<Turn::End> SlidingMotion::slide(double t_end, const std::function<bool(const FlowVector&)>& settled,
                                              Turn& turn)
{
    const double from = stepper_->time();
    const FlowVector before = y_;
    const double limit =
        as_.delayed ? std::min(t_end, t_ + as_.delayed->step_limit(y_) - as_.delayed->clock(y_)) : t_end;
    ++turn.steps;
    auto report = stepper_->step(limit - clock_.zero);
    if (report.end == StepEnd::failure) {
        if (step_failed()) return Turn::End::failure;
        return {};
    }
    t_ = report.end == StepEnd::time ? limit : clock_.zero + stepper_->time();
    y_ = stepper_->state();
    double to = stepper_->time();
    const auto touch = to > from ? touched(from, before) : std::nullopt;
    if (touch && touch->time < to) {
        report = {StepEnd::event, touch->event, -1};
        to = touch->time, t_ = clock_.zero + to, y_ = stepper_->at(to);
    }
    if (as_.delayed) as_.delayed->remember(before, y_, [&](double f) { return stepper_->at(from + f * (to - from)); });
    if (to > from) effort_.idle_switches = 0;
    if (clock_.steps > settled_steps) effort_.restarts = 0;
    const bool at_rest = as_.sticking && report.end == StepEnd::event && report.event == rest;
    if (at_rest) y_[1] = 0;
    measure_step(from, to, before, report, turn);
    const bool switched = as_.switching && report.end == StepEnd::event && report.event >= rest;
    if (at_rest)
        arrive_at_rest();
    else if (switched && !pass_switch(report.event - rest))
        return Turn::End::failure;
    else if (!switched && ++clock_.steps > settled_steps && to - from < resolved_step * from)
        restart();
    notify();
    if (report.end == StepEnd::event && report.event == section && report.direction < 0) return Turn::End::crossing;
    if (report.end == StepEnd::time && t_ >= t_end) return Turn::End::time;
    if (settled && !rest_.stuck && settled(y_)) return Turn::End::settled;
    return {};
}

bool SlidingMotion::advance(double t_end, int most_steps)
{
    effort_.steps_left = effort_.patience_left = most_steps;
    while (t_ < t_end) {
        const auto end = run(t_end, {}).end;
        if (end == Turn::End::failure || end == Turn::End::held) return false;
    }
    return true;
}

}  // namespace stickslip
