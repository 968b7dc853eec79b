// Mechanisms and actuators from tick to tick, a pack of joints side by side, each along its own record.
// In one file: one time step of the mechanics, written once for every width of lanes.
#pragma once
#include "analysis/diagnosis/plant/held_command.h"
#include "analysis/diagnosis/plant/step.h"
#include "analysis/joint/spring.h"

namespace stickslip::gap {

/// Where a link rests at the start: pressed onto its spring and one flank of its backlash by the load, or, as whoever
/// switches a simulation or a brake on finds it, level with the motor, in the middle of its backlash.
enum class Rest { pressed, level };

/// Where readings come late, the motion is that of the moment which is read, so that a reading is compared with what it
/// shows; the effort that is logged beside it is not late.
template <class P, class K = Kind>
class Mechanics {
  public:
    static constexpr int lanes = P::lanes;

    explicit Mechanics(const Kind& kind) : joints_(kind) {}

    /// Puts a joint of this kind and its record into a lane, at a tick. They must outlive the lane.
    void load(int lane, const Plant& plant, const Ticks& ticks, std::span<const double> command, std::size_t tick)
    {
        joints_.load_lane(lane, plant);
        Lane& l = lane_[lane];
        l.ticks = &ticks, l.plant = &plant, l.tick = tick, l.command = command.data();
        l.held = HeldCommand(ticks, command, plant.dead_time, tick);
        if (kind().sensor_delay) l.logged = HeldCommand(ticks, command, plant.dead_time - plant.sensor.delay, tick);
        l.longest = longest_step(plant), l.parts = 0, l.divided = 0, l.goes = true;
        logged_lagged_.set(lane, 0), began_.set(lane, ticks.began);
        motor_level_.set(lane, plant.motor.coulomb), link_level_.set(lane, plant.link.coulomb);
        moves_inertia_ = loaded_ = false;
        for (const auto& other : lane_) {
            if (!other.ticks) continue;
            moves_inertia_ = moves_inertia_ || !other.ticks->inertia.empty() || other.plant->free.moves_inertia;
            loaded_ = loaded_ || !other.ticks->load.empty();
        }
        length_of_ = P(0.0);  // to be divided anew
        if (kind().lag) lag_.set(lane, plant.actuator.lag);
    }
    /// Begins where this lane's tick is, with this velocity, this far beyond the reading.
    void start(int lane, double velocity, Rest rest = Rest::pressed, double beyond = 0);

    /// Behind the actuator's lag every lane holds this command, as one that moves already does.
    void hold(double command) { state_.lagged = logged_lagged_ = P(command); }

    /// Every lane that goes is where this one is, on the same record; -1: they differ.
    void read_once(int lane)
    {
        once_ = lane;
        same_command_ = lane >= 0;
        for (const auto& l : lane_) same_command_ = same_command_ && (!l.goes || l.command == lane_[lane].command);
    }

    std::size_t tick(int lane) const { return lane_[lane].tick; }
    /// Whether a lane goes on from tick to tick.
    void stop(int lane) { lane_[lane].goes = false; }

    P seen_position() const { return kind().feedback_link ? state_.link_position : state_.motor_position; }
    P seen_velocity() const { return kind().feedback_link ? state_.link_velocity : state_.motor_velocity; }
    P reading() const { return joints_.position_scale * seen_position() + joints_.position_offset; }

    /// The effort as it is measured just after the update at this tick, before the step is taken.
    P effort_now()
    {
        constexpr double moment = 1e-9;  // numerical: s
        P arrived;
        for (int i = 0; i < lanes; ++i) {
            Lane& l = lane_[i];
            const double t = l.ticks->time[l.tick];
            arrived.set(i, (kind().sensor_delay ? l.logged : l.held).mean(t, moment, l.tick));
        }
        if (kind().lag) arrived = kind().sensor_delay ? logged_lagged_ : state_.lagged;
        return joints_.effort_scale * drive_by(arrived).at(state_.motor_velocity).at(state_.motor_velocity);
    }

    /// Every lane by a tick. Flattened: packs passed by memory cost more than what is done with them.
    [[gnu::flatten]] void advance()
    {
        P tick, start;
        if (once_ >= 0) {
            const Lane& l = lane_[once_];
            tick = P(l.ticks->step[l.tick]), start = P(l.ticks->time[l.tick]);
        }
        for (int i = 0; i < lanes && once_ < 0; ++i) {
            const Lane& l = lane_[i];
            tick.set(i, l.ticks->step[l.tick]), start.set(i, l.ticks->time[l.tick]);
        }
        if (any(tick != length_of_)) divide(tick);
        follow_record(start - joints_.sensor_delay + 0.5 * tick);
        if (changes()) length_ = StepLength<P>(joints_, length_.h);
        const StepLength<P>& length = length_;
        State<P> s = state_;  // out of memory, as far as registers go
        HeldDrive<P> held;
        PushOf<P> drive;
        P arrived(0.0), keep, mean_keep;
        const bool asked_again = !kind().holds() || kind().actuator == ActuatorKind::dc_motor;
        if (kind().holds()) held = drive_by(command()), drive = held.at(s.motor_velocity);
        if (kind().lag) {
            keep = exp_of(-length.h / lag_);
            mean_keep = lag_ / length.h * (1.0 - keep);
        }
        const auto substep = [&](int part) {
            const P t = start + P(part) * length.h;
            if (!kind().holds()) {
                const P now = arriving(s, t, keep, mean_keep);
                if (part == 0 || any(now != arrived)) arrived = now, held = drive_by(now);
            }
            if (asked_again) drive = held.at(s.motor_velocity);
            if (kind().two_mass)
                step_two_mass(joints_, s, drive, t - joints_.sensor_delay, length);
            else
                step_single(joints_, s, drive, t - joints_.sensor_delay, length);
        };
        for (int part = 0; part < fewest_parts_; ++part) substep(part);
        for (int part = fewest_parts_; part < most_parts_; ++part) {
            const State<P> before = s;
            substep(part);
            keep_done(s, before, part);
        }
        state_ = s;
        for (auto& l : lane_) l.tick += l.goes;
    }

    /// Moves the state by what an observer asks for.
    void correct(const P& error, const P& gain_position, const P& gain_velocity)
    {
        const P dq = gain_position * error / joints_.position_scale;
        const P dv = gain_velocity * error / joints_.position_scale;
        if (!kind().two_mass) {
            state_.motor_position = state_.motor_position + dq;
            state_.motor_velocity = state_.motor_velocity + dv;
            return;
        }
        const P one(1.0), zero(0.0);
        const P to_motor = kind().feedback_link ? joints_.ratio : one,
                to_link = kind().feedback_link ? one : one / joints_.ratio;
        // inside the backlash the link flies on its own: an encoder on the motor says nothing about it, and its noise
        // would be fed into a body that nothing calms. In contact it moves along
        const P apart = state_.motor_position / joints_.ratio - state_.link_position;
        state_.motor_position = state_.motor_position + to_motor * dq;
        state_.motor_velocity = state_.motor_velocity + to_motor * dv;
        P moved = to_link * dq, sped = to_link * dv;
        if (kind().has_backlash && !kind().feedback_link) {
            const auto touches = beyond_backlash(apart, joints_.backlash) != zero;
            moved = select(touches, moved, zero), sped = select(touches, sped, zero);
        }
        state_.link_position = state_.link_position + moved;
        state_.link_velocity = state_.link_velocity + sped;
    }

  private:
    struct Lane {
        const Plant* plant = nullptr;
        const Ticks* ticks = nullptr;
        const double* command = nullptr;
        HeldCommand held;    ///< that moves what is read
        HeldCommand logged;  ///< behind the effort that is logged
        std::size_t tick = 0;
        double longest = 1;  ///< s, time step
        int parts = 0;       ///< of a tick of the length `divided`
        double divided = 0;
        bool goes = true;
    };

    const K& kind() const { return joints_.kind; }
    /// Whether what is divided once for a tick is another in the next: of one mass the inertia alone.
    bool changes() const { return moves_inertia_ || (kind().two_mass && (kind().motor.drifts || kind().link.drifts)); }

    /// Divides ticks of these lengths into substeps.
    void divide(const P& tick)
    {
        constexpr double rounding = 1e-9;  // numerical: of a clock
        most_parts_ = 0, fewest_parts_ = 1 << 30;
        for (int i = 0; i < lanes; ++i) {
            Lane& l = lane_[i];
            if (!(std::abs(tick[i] - l.divided) <= rounding * l.divided))
                l.parts = substeps(tick[i], l.longest), l.divided = tick[i];
            parts_.set(i, l.parts);
            most_parts_ = std::max(most_parts_, l.parts), fewest_parts_ = std::min(fewest_parts_, l.parts);
        }
        length_of_ = tick;
        length_ = StepLength<P>(joints_, tick / parts_);
    }

    /// What a known column says of the whole of this tick: its mean, since what surrounds the joint goes straight from
    /// row to row and is not held as a command is.
    static double over_tick(const std::vector<double>& column, std::size_t tick)
    {
        return 0.5 * (column[tick] + column[std::min(tick + 1, column.size() - 1)]);
    }

    /// What the record or a drift says of this tick.
    void follow_record(const P& middle)
    {
        if (kind().motor.drifts) joints_.motor.coulomb = motor_level_ + drifted(joints_.motor, middle - began_);
        if (kind().link.drifts) joints_.link.coulomb = link_level_ + drifted(joints_.link, middle - began_);
        if (!loaded_ && !moves_inertia_) return;
        for (int i = 0; i < lanes; ++i) {
            const Lane& l = lane_[i];
            if (!l.ticks->load.empty())
                joints_.load.constant.set(i, l.plant->load.constant + over_tick(l.ticks->load, l.tick));
            if (l.ticks->inertia.empty() && !l.plant->free.moves_inertia) continue;
            double factor = l.ticks->inertia.empty() ? 1 : over_tick(l.ticks->inertia, l.tick);
            if (l.plant->free.moves_inertia) factor *= l.plant->free.inertia_factor(middle[i]);
            if (kind().two_mass)
                joints_.link_inertia.set(i, l.plant->link_inertia * factor);
            else
                joints_.motor_inertia.set(i, l.plant->motor_inertia * factor);
        }
    }

    P command() const
    {
        if (same_command_) return P(lane_[once_].command[lane_[once_].tick]);
        P u;
        for (int i = 0; i < lanes; ++i) u.set(i, lane_[i].command[lane_[i].tick]);
        return u;
    }

    /// The command that reaches the actuator's coils in the substep from t on.
    P arriving(State<P>& s, const P& t, const P& keep, const P& mean_keep)
    {
        P arrived;
        for (int i = 0; i < lanes; ++i) arrived.set(i, lane_[i].held.mean(t[i], length_.h[i], lane_[i].tick));
        if (!kind().lag) return arrived;
        if (kind().sensor_delay) {
            P at_once;
            for (int i = 0; i < lanes; ++i) at_once.set(i, lane_[i].logged.mean(t[i], length_.h[i], lane_[i].tick));
            logged_lagged_ = at_once + (logged_lagged_ - at_once) * keep;
        }
        const P gap = s.lagged - arrived;
        s.lagged = arrived + gap * keep;
        return arrived + gap * mean_keep;
    }

    HeldDrive<P> drive_by(const P& arrived) const
    {
        P supply(0.0);
        if (kind().actuator == ActuatorKind::dc_motor)
            for (int i = 0; i < lanes; ++i) supply.set(i, lane_[i].ticks->supply[lane_[i].tick]);
        HeldDrive<P> d = held_drive(joints_.actuator, arrived, supply);
        if (once_ >= 0 && lane_[once_].ticks->enabled[lane_[once_].tick]) return d;
        for (int i = 0; i < lanes; ++i)
            if (!lane_[i].ticks->enabled[lane_[i].tick])
                for (auto* p : {&d.driven, &d.feeding}) p->push.set(i, 0), p->drag.set(i, 0);
        return d;
    }

    /// Takes this substep back in lanes that have fewer.
    void keep_done(State<P>& s, const State<P>& before, int part) const
    {
        const typename P::MaskType done = parts_ <= P(part);
        each_number(s, before, [&](P& now, const P& then) { now = select(done, then, now); });
    }
    template <class F>
    static void each_number(State<P>& a, const State<P>& b, F f)
    {
        f(a.motor_position, b.motor_position), f(a.motor_velocity, b.motor_velocity);
        f(a.link_position, b.link_position), f(a.link_velocity, b.link_velocity);
        f(a.acceleration, b.acceleration), f(a.lagged, b.lagged), f(a.followed, b.followed);
        f(a.driven_apart, b.driven_apart);
        f(a.motor.bristle, b.motor.bristle), f(a.motor.theta, b.motor.theta);
        f(a.motor.speed, b.motor.speed), f(a.motor.force, b.motor.force);
        f(a.motor.gained, b.motor.gained), f(a.link.gained, b.link.gained);
        f(a.link.bristle, b.link.bristle), f(a.link.theta, b.link.theta);
        f(a.link.speed, b.link.speed), f(a.link.force, b.link.force);
    }

    Joints<P, K> joints_;  ///< with the levels of friction, the load and the inertia of this tick
    State<P> state_;
    Lane lane_[lanes];
    P logged_lagged_ = 0, motor_level_ = 0, link_level_ = 0, lag_ = 1, began_ = 0;
    P length_of_ = 0;  ///< s, ticks that `length_` divides
    StepLength<P> length_;
    P parts_ = 1;  ///< of this tick, lane by lane
    int most_parts_ = 0, fewest_parts_ = 0;
    bool moves_inertia_ = false, loaded_ = false;
    int once_ = -1;  ///< whose row is read for all
    bool same_command_ = false;
};

template <class P, class K>
void Mechanics<P, K>::start(int lane, double velocity, Rest rest, double beyond)
{
    const Lane& l = lane_[lane];
    const Plant& p = *l.plant;
    const double q = (l.ticks->position[l.tick] + beyond - p.sensor.position_offset) / p.sensor.position_scale;
    const double v = velocity / p.sensor.position_scale;
    State<P> fresh;
    const double per_link = kind().two_mass && !p.feedback_link ? 1 / p.ratio : 1;
    const double per_motor = kind().two_mass && p.feedback_link ? p.ratio : 1;
    fresh.motor = steady_state(joints_.motor, P(per_motor * v));
    fresh.link = steady_state(joints_.link, P(per_link * v));
    fresh.motor_position = fresh.followed = q;
    fresh.motor_velocity = v;
    if (kind().two_mass) {
        const double link = per_link * q;
        const double acceleration =
            l.tick == 0 ? per_link * l.ticks->initial_acceleration / p.sensor.position_scale : 0;
        // what the spring does not give the link
        const double load = load_force(joints_.load, P(link), P(l.ticks->time[l.tick]))[lane] -
                            sliding_force(joints_.link, fresh.link, P(per_link * v))[lane] -
                            joints_.link_inertia[lane] * acceleration;
        // a load that the link's own friction holds leaves open where in its backlash the link rests: the middle is
        // nearest
        const bool held = v == 0 && p.backlash > 0 && std::abs(load) <= p.link.coulomb;
        const double stretch = held || rest == Rest::level ? 0 : Spring{p.stiffness, p.cubic_stiffness}.stretch(-load);
        const double half = stretch == 0 ? 0 : std::copysign(0.5 * p.backlash, stretch);
        fresh.motor_position = p.feedback_link ? p.ratio * (q + stretch + half) : q;
        fresh.link_position = p.feedback_link ? q : q / p.ratio - stretch - half;
        fresh.motor_velocity = p.feedback_link ? p.ratio * v : v;
        fresh.link_velocity = p.feedback_link ? v : v / p.ratio;
        fresh.followed = fresh.link_position;
        // the load holds the spring
        fresh.driven_apart = Spring{p.stiffness, p.cubic_stiffness}.effort(stretch) *
                             apart_per_force(p.motor_inertia, p.link_inertia, p.ratio);
    }
    each_number(state_, fresh, [lane](P& now, const P& then) { now.set(lane, then[lane]); });
}

}  // namespace stickslip::gap
