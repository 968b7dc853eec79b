#include "analysis/simulation/set_point/sampled_stops.h"

#include "analysis/base/work_limits.h"
#include "analysis/simulation/set_point/loop_times.h"
#include "analysis/simulation/set_point/set_point_load.h"
#include "analysis/stability/effort_limits.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace stickslip {
namespace {

constexpr double rtol = 1e-8;
constexpr double far = 1e4;          ///< times the start: no loop that settles goes there
constexpr double creep_like = 0.02;  ///< by which the speed of a creep differs from that of the slowest root
constexpr double creep_times = 3;    ///< of the next time constant, over which it is so: nothing else is left then
constexpr double no_speed = 1e-6;    ///< of the start, per slowest time constant: at rest but for rounding
constexpr double arrived = 1e-4;     ///< of the start: a slip that creeps so near has settled
constexpr double forgets = 8;        ///< time constants of filters and lags after which they are at rest
constexpr double most_stops = 400;   ///< within one motion, none of which lasts: it does not come to rest
constexpr double slow_times = 200;   ///< of the slowest time constant: what has not stopped by then does not

double falling_speed(const Friction& friction)
{
    const auto* curve = std::get_if<Stribeck>(&friction.law);
    return curve && curve->c2 > 0 ? curve->c3 : infinity;
}

}  // namespace

SampledStops::SampledStops(const Joint& joint, const Regulator& regulator, double viscous)
    : joint_(joint),
      regulator_(regulator),
      static_(stickslip::static_force(joint.friction)),
      per_signal_(regulator.per_signal),
      set_place_(-joint.sensor.position_offset / joint.sensor.position_scale)
{
    const auto times = times_of(regulator, viscous);
    slow_time_ = times.slow, next_time_ = times.next, creeps_ = times.creeps && regulator.k_i > 0;
    const auto& c = joint.control;
    const double T = tick_of(joint);
    late_ = joint.dead_time() + forgets * joint.actuator.lag;
    flush_ = late_ + (c.velocity_estimate.average + 2) * T + forgets * c.velocity_estimate.tau;
}

bool SampledStops::one_sided() const
{
    return pull_at(joint_, 0, per_signal_).on_limits != 0;
}

/// The furthest place whose reading is at most that of an exact encoder at this distance: half a step beyond the last
/// step within it.
double SampledStops::furthest_with(double distance) const
{
    constexpr double rounding = 1e-12;
    const double step = joint_.sensor.encoder_quantum / std::abs(joint_.sensor.position_scale);
    return step > 0 ? step * (std::floor(distance / step * (1 + rounding)) + 0.5) : distance;
}

double SampledStops::unseen() const
{
    return furthest_with(regulator_.dead_zone);
}

/// What breaks the static friction towards the set point.
double SampledStops::effort_at_breakaway(double x) const
{
    return (x < 0 ? static_ : -static_) - pull_at(joint_, x, per_signal_).on_limits;
}

/// What the encoder reads at x.
double SampledStops::read(double x) const
{
    const double q = joint_.sensor.encoder_quantum, y = reading(x);
    return q > 0 ? q * std::round(y / q) : y;
}

/// As the controller counts it, in the encoder's units.
double SampledStops::seen_error(double x) const
{
    const double zone = joint_.control.dead_zone;
    return -read(x) - std::clamp(-read(x), -zone, zone);
}

bool SampledStops::can_break(double x) const
{
    const auto& c = joint_.control;
    const double effort = effort_at_breakaway(x), command = command_for(joint_.actuator, effort, 0);
    if (!std::isfinite(command) || std::abs(command) > c.effort_limit || std::abs(effort) > regulator_.effort_limit)
        return false;
    const double e = seen_error(x);
    if (e == 0 || std::abs(reading(x)) > c.integral_band) return false;
    const auto pull = pull_at(joint_, x, per_signal_);
    const double without_integral =
        regulator_.push_at_rest(read(x) / joint_.sensor.position_scale) + pull.on_feedback - pull.on_limits;
    return std::abs(command - without_integral / per_signal_) <= c.integral_limit;
}

SampledLoop SampledStops::rest_at(double x) const
{
    LoopOptions options;
    options.motion.rtol = rtol;
    options.readings = false;
    const double speed = std::min(std::abs(x) / slow_time_, falling_speed(joint_.friction));
    return SampledLoop(joint_, 0, speed, LoopSide::motor, options);
}

double SampledStops::stick_time(const SampledLoop& loop, double x) const
{
    if (!can_break(x)) return infinity;
    const auto& controller = loop.controller();
    const double missing_command = command_for(joint_.actuator, effort_at_breakaway(x), 0) - controller.wanted();
    // the command goes up in steps, and on average half a tick before the ramp through their ends; what the joint feels
    // is a dead time and, of a ramp, a time constant of the lag older
    const double steps = missing_command / controller.winding() - 0.5 * loop.period();
    return std::max(0.0, steps) + joint_.control.delay + joint_.actuator.lag;
}

SampledStop SampledStops::slip_from(double x) const
{
    SampledStop stop;
    if (!can_break(x)) return stop.end = SampledStop::End::held, stop;
    SampledLoop loop = rest_at(x);
    const double T = loop.period(), command = command_for(joint_.actuator, effort_at_breakaway(x), 0);
    loop.begin_holding(reading(x), command);
    // so far back that delay and lag are full of the ramp, and half a tick of it beyond the breakaway at a tick
    const double ticks = std::ceil(late_ / T) + 2;
    loop.begin_holding(reading(x), command - (ticks - 0.5) * T * loop.controller().winding());
    return follow(loop, x);
}

SampledStop SampledStops::release_from(double x) const
{
    SampledLoop loop = rest_at(x);
    loop.begin_at_rest(reading(x));
    return follow(loop, x);
}

/// Of one motion from a rest: what its ticks were so far.
class SampledStops::Watch {
  public:
    Watch(const SampledStops& stops, const SampledLoop& loop, double from)
        : stops_(stops), loop_(loop), start_(std::abs(from))
    {
    }

    void step(const DrivenStep& s)
    {
        if (s.joint.modes[0] == DrivenJoint::Mode::stuck) {
            still_ += s.step.h;
            return;
        }
        if (still_ > 0 && began_) ++rests_;
        moves_ = began_ = true;
        still_ = 0, moved_ += s.step.h;
    }

    /// After a tick: how the motion ended, or nothing.
    std::optional<SampledStop> ended()
    {
        const bool moves = std::exchange(moves_, false);
        const double tick = loop_.period(), x = loop_.motion.y[0] - stops_.set_place_, v = loop_.motion.y[1];
        if (!std::isfinite(x)) return SampledStop{};
        reach_ = std::max(forgotten_a_tick * reach_, std::abs(x));
        if (std::abs(x) > far * start_) return as(SampledStop::End::runaway, x);
        if (!began_) {
            waited_ += tick;
            if (waited_ > stops_.flush_ + stops_.late_ + spare_ticks * tick) return as(SampledStop::End::held, x);
            return {};
        }
        if (!moves && still_ > stops_.flush_) {
            const double stick = loop_.integrates() ? still_ + stops_.stick_time(loop_, x) : infinity;
            return as(SampledStop::End::stop, x, stick);
        }
        const double pace = std::abs(v) * stops_.slow_time_;
        idle_ = pace < no_speed * start_ ? idle_ + tick : 0;
        if (!loop_.integrates() && idle_ > stops_.flush_) return as(SampledStop::End::stop, x, infinity);
        // towards the edge of the dead zone, as towards the set point
        const double left = std::abs(x) - stops_.regulator_.dead_zone;
        const bool creeps = stops_.creeps_ && left > 0 && x * v < 0 && std::abs(pace - left) < creep_like * left;
        crept_ = creeps ? crept_ + tick : 0;
        const bool home = std::abs(x) < arrived * start_ && pace < arrived * start_;
        if (home || crept_ > creep_times * stops_.next_time_) return as(SampledStop::End::settled, x);
        if (rests_ > most_stops || moved_ > slow_times * stops_.slow_time_) return as(SampledStop::End::moves, reach_);
        return {};
    }

  private:
    SampledStop as(SampledStop::End end, double x, double stick = missing) const { return {end, x, moved_, stick}; }

    static constexpr double forgotten_a_tick = 0.999;  ///< of the largest distance of late
    static constexpr double spare_ticks = 10;          ///< in which a motion begins that begins at all

    const SampledStops& stops_;
    const SampledLoop& loop_;
    double start_, moved_ = 0, still_ = 0, waited_ = 0, reach_ = 0, idle_ = 0, crept_ = 0;
    int rests_ = 0;
    bool began_ = false, moves_ = false;
};

SampledStop SampledStops::follow(SampledLoop& loop, double from) const
{
    Watch watch(*this, loop, from);
    for (long k = 0; k < work::ticks_of_slip; ++k) {
        if (!loop.tick(0, 0, 0, [&](const DrivenStep& s) { watch.step(s); })) break;
        if (const auto stop = watch.ended()) return *stop;
    }
    return {};
}

double SampledStops::band(double side) const
{
    constexpr int turns = 100;
    constexpr double same = 1e-12;
    double x = 0;
    for (int i = 0; i < turns; ++i) {
        const double pull = side * pull_at(joint_, side * x, per_signal_).on_feedback;
        const double before = x, effort = static_ + pull;
        // a supply that sags takes more command for it
        const double asked = std::abs(command_for(joint_.actuator, effort, 0) * per_signal_);
        if (!std::isfinite(asked)) return infinity;
        x = effort > 0 ? regulator_.dead_zone + regulator_.error_holding(asked) : regulator_.dead_zone;
        if (std::abs(x - before) <= same * x) break;
    }
    return furthest_with(x);
}

double SampledStops::least_start(double side) const
{
    const double pull = side * pull_at(joint_, 0, per_signal_).on_feedback;
    return furthest_with(regulator_.dead_zone + regulator_.error_holding(static_ + pull - regulator_.integral_limit));
}

}  // namespace stickslip
