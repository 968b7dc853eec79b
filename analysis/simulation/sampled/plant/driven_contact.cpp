// Friction of a driven joint's bodies: what it answers, what it holds at rest, when a body sticks or slips.
#include "analysis/simulation/sampled/plant/driven_joint.h"

#include "analysis/friction/level.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

/// Change of a level, per itself, by which slopes are taken that no law states.
constexpr double small_change = 1e-6;

}  // namespace

/// What place, time and load add to the level of body i, at its own side.
DrivenJoint::Extra DrivenJoint::extra(const double* y, int i) const
{
    const auto& b = body_[i];
    const auto& f = b.friction;
    Extra e{};
    const double t = now(y);
    if (f.ripple.acts()) {
        const double place = b.ratio * (frame_ * t + y[i]);
        e.level += wave_at(f.ripple, place);
        e.by_place += b.ratio * f.ripple.by_place(place);
        e.by_time += frame_ * e.by_place;
    }
    if (f.drift.change != 0) {
        const double left = std::exp(-(t - began) / f.drift.time_constant);
        e.level += f.drift.change * (1 - left);
        e.by_time += f.drift.change * left / f.drift.time_constant;
    }
    if (f.load_coefficient != 0) {
        double a, c;
        const double through = bodies() == 1 ? drive(y).effort : spring(y, std::max(0, i - 1), &a, &c);
        e.level += f.load_coefficient * std::abs(through) / b.ratio / f.normal_load;
    }
    return e;
}

/// What the gear of a single mass adds to its level in motion against other friction of this size.
double DrivenJoint::gear_level(const double* y, double direction, double other) const
{
    const auto& f = body_[0].friction;
    double by_place, by_time;
    const double pushed = load(y, &by_place, &by_time);
    return GearLoss::level(f.gear.forward, f.gear.backward, f.gear.beyond, -pushed, drive(y).effort + pushed, direction,
                           other) /
           f.normal_load;
}

/// The most that it adds at rest, where nothing accelerates.
double DrivenJoint::gear_level_at_rest(const double* y, double direction) const
{
    const auto& f = body_[0].friction;
    double by_place, by_time;
    const double pushed = load(y, &by_place, &by_time);
    return GearLoss::level(f.gear.forward, f.gear.backward, 0.0, -pushed, 0.0, direction, 0.0) / f.normal_load;
}

FrictionResponse DrivenJoint::respond_as(const BodyData& b, const Friction& friction, Mode mode, const double* y,
                                         int i) const
{
    States theta{};
    std::copy_n(y + b.first_state, b.states, theta.begin());
    if (b.logarithmic) return respond_logarithmic(friction, y[bodies() + i], b.ratio * b.speed, theta);
    const double V = b.ratio * y[bodies() + i];
    if (!b.rests) return respond(friction, V, theta);
    const auto branch = mode == Mode::reverse ? Branch::reverse : Branch::forward;
    return respond_on(friction, branch, V, b.ratio * b.edge / rest_speed, theta);
}

/// What the friction of body i resists where its level is delayed, at its own side.
double DrivenJoint::delayed_level(const double* y, int i, bool backwards) const
{
    const auto& b = body_[i];
    const double then = std::abs(past_.then(i, now(y)).value);
    return delayed_force(b.friction, b.ratio * std::max(then, rest_speed * b.speed), backwards);
}

/// Its change in time.
double DrivenJoint::delayed_change(const double* y, int i) const
{
    const auto& b = body_[i];
    const auto then = past_.then(i, now(y));
    const double V = b.ratio * std::abs(then.value);
    if (!(V > rest_speed * b.ratio * b.speed)) return 0;
    const double slope = delayed_slope(b.friction, V, modes[i] == Mode::reverse);
    return slope * b.ratio * std::copysign(then.slope, then.slope * then.value);
}

void DrivenJoint::begin_past(const double* y, double velocity)
{
    if (!has_delayed_friction()) return;
    PastSpeeds::Speeds before{};
    before.fill(velocity);
    past_.begin(now(y), before);
}

double DrivenJoint::step_limit(const double* y)
{
    std::array<bool, max_bodies> rests{};
    for (int i = 0; i < bodies(); ++i) rests[i] = modes[i] == Mode::stuck;
    return past_.step_limit(now(y), rests);
}

void DrivenJoint::note_kink(const double* y, int lags)
{
    if (has_delayed_friction()) past_.note_kink(now(y), lags);
}

DrivenJoint::Contact DrivenJoint::contact(const double* y, int i, bool derivatives) const
{
    const auto& b = body_[i];
    if (b.delayed) {
        Contact delayed;
        delayed.r.force = delayed_level(y, i, modes[i] == Mode::reverse);
        return delayed;
    }
    if (!b.bent) return {respond_as(b, b.friction, modes[i], y, i)};
    Friction raised = b.friction;
    raise(raised.law, extra(y, i).level);
    Contact c{respond_as(b, raised, modes[i], y, i)};
    if (b.friction.gear.acts()) {
        raise(raised.law, gear_level(y, modes[i] == Mode::reverse ? -1 : 1, std::abs(c.r.force)));
        c.r = respond_as(b, raised, modes[i], y, i);
    }
    if (!derivatives) return c;
    const double change = small_change * (std::abs(c.r.force) + std::abs(extra(y, i).level) + 1e-300);
    raise(raised.law, change);
    const auto more = respond_as(b, raised, modes[i], y, i);
    c.by_level = (more.force - c.r.force) / change;
    for (int j = 0; j < b.states; ++j) c.rate_by_level[j] = (more.rate[j] - c.r.rate[j]) / change;
    return c;
}

/// The most that body i resists at rest against motion on this branch, in joint coordinates.
double DrivenJoint::limit(const double* y, int i, Branch branch) const
{
    const auto& b = body_[i];
    if (b.delayed) {
        // a curve with a jump at V = 0 is set-valued there, and what a body resisted a lag ago it may still resist
        const bool backwards = branch == Branch::reverse;
        const double at_rest = std::abs(delayed_force(b.friction, b.ratio * rest_speed * b.speed, backwards));
        const double most = std::max(static_force(b.friction), at_rest);
        return b.ratio * std::max(most, std::abs(delayed_level(y, i, backwards)));
    }
    DrivenState still;
    std::copy_n(y, size_, still.begin());
    const double V = branch == Branch::forward ? b.release : -b.release;
    still[bodies() + i] = V;
    Friction raised = b.friction;
    if (b.bent) raise(raised.law, extra(y, i).level);
    if (b.friction.gear.acts()) raise(raised.law, gear_level_at_rest(y, branch == Branch::forward ? 1 : -1));
    const Mode mode = branch == Branch::forward ? Mode::forward : Mode::reverse;
    const double sliding = std::abs(respond_as(b, raised, mode, still.data(), i).force);
    // what a law resists at rest beyond the end of its curve: of kinetic and static friction
    const double curve = raised.normal_load * std::abs(respond(raised.law, b.ratio * b.edge, {}).force);
    return b.ratio * (sliding + std::max(0.0, static_force(raised) - curve));
}

void DrivenJoint::switch_values(const double* y, double* values) const
{
    const int n = bodies();
    for (int i = 0; i < n; ++i) {
        if (!body_[i].rests)
            values[i] = 1;
        else if (modes[i] == Mode::stuck)
            values[i] =
                std::min(limit(y, i, Branch::forward) - needed(y, i), limit(y, i, Branch::reverse) + needed(y, i));
        else
            values[i] = (modes[i] == Mode::forward ? 1 : -1) * y[n + i];
    }
    for (int i = 0; i + 1 < n; ++i)
        values[n + i] = backlash_[i] > 0 ? std::abs(y[i] - y[i + 1]) - 0.5 * backlash_[i] : 1;
}

void DrivenJoint::settle(int i, double* y)
{
    y[bodies() + i] = 0;
    const double force = needed(y, i);
    modes[i] = force > limit(y, i, Branch::forward)    ? Mode::forward
               : force < -limit(y, i, Branch::reverse) ? Mode::reverse
                                                       : Mode::stuck;
}

/// Puts the bodies beside a backlash onto its flank, to the last digit and, where they close in, not short of it. The
/// damper's force begins there at once, and what it presses against may give way.
void DrivenJoint::meet_flank(int i, double* y)
{
    const double half = 0.5 * backlash_[i], side = std::copysign(1.0, y[i] - y[i + 1]);
    const bool closes = side * (velocity(y, i) - velocity(y, i + 1)) > 0;
    y[i] = y[i + 1] + side * half;
    if (!closes) return;
    while (side * (y[i] - y[i + 1]) < half) y[i] = std::nextafter(y[i], side * infinity);
    for (const int k : {i, i + 1})
        if (body_[k].rests && modes[k] == Mode::stuck) settle(k, y);
}

void DrivenJoint::pass(int which, double* y)
{
    note_kink(y, PastSpeeds::felt_lags);
    if (which >= bodies()) return meet_flank(which - bodies(), y);
    if (modes[which] == Mode::stuck)
        modes[which] = needed(y, which) > 0 ? Mode::forward : Mode::reverse;
    else
        settle(which, y);
}

void DrivenJoint::enter(double* y)
{
    // jumps of a command come every tick: what is left of them after two lags is for the error control of the steps
    note_kink(y, 1);
    for (int i = 0; i < bodies(); ++i) {
        if (!body_[i].rests) continue;
        if (y[bodies() + i] == 0)
            settle(i, y);
        else
            modes[i] = y[bodies() + i] > 0 ? Mode::forward : Mode::reverse;
    }
}

bool DrivenJoint::driven_backwards(const double* y) const
{
    for (int i = 0; i < bodies(); ++i)
        if (body_[i].logarithmic && contact(y, i, false).r.force < 0) return true;
    return false;
}

double DrivenJoint::link_friction(const double* y) const
{
    if (modes[link()] == Mode::stuck) return needed(y, link());
    return contact(y, link(), false).r.force;
}

}  // namespace stickslip
