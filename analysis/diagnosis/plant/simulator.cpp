#include "analysis/diagnosis/plant/simulator.h"

#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/plant/step.h"
#include "analysis/numerics/seeded_noise.h"

#include <cmath>

namespace stickslip::gap {
namespace {

/// The held command as the actuator sees it after the dead time, averaged over a substep.
class HeldCommand {
  public:
    HeldCommand(const Ticks& ticks, std::span<const double> command, double dead_time)
        : time_(ticks.time), command_(command), dead_time_(dead_time)
    {
    }

    /// Mean over [t, t + h]; before the first tick the command was zero. `now` is the tick that holds t.
    double mean(double t, double h, std::size_t now)
    {
        if (dead_time_ == 0) return command_[now];
        const double from = t - dead_time_, to = from + h;
        while (next_ < time_.size() && next_ <= now && time_[next_] <= from) ++next_;
        const double held = next_ == 0 ? 0 : command_[next_ - 1];
        if (next_ > now || time_[next_] >= to) return held;
        const double share = (time_[next_] - from) / h;
        return share * held + (1 - share) * command_[next_];
    }

  private:
    const std::vector<double>& time_;
    std::span<const double> command_;
    double dead_time_;
    std::size_t next_ = 0;  ///< first tick whose command has not yet reached the actuator
};

/// Where a link rests at the start: pressed onto its spring and one flank of its play by the load, or, as whoever
/// switches a simulation or a brake on finds it, level with the motor, in the middle of its play.
enum class Rest { pressed, level };

/// Mechanism and actuator over one tick. Where readings come late, the motion is that of the moment which is read, so
/// that a reading is compared with what it shows; the effort that is logged beside it is not late.
class Mechanics {
  public:
    Mechanics(const Plant& plant, const Ticks& ticks, std::span<const double> command)
        : plant_(plant),
          ticks_(ticks),
          held_(ticks, command, plant.dead_time),
          logged_(ticks, command, plant.dead_time - plant.sensor.delay),
          length_(plant, ticks.step[0])
    {
    }

    State state;

    /// Begins at tick k with this velocity, this far beyond the reading.
    void start(std::size_t k, double velocity, Rest rest = Rest::pressed, double beyond = 0)
    {
        const double q = (ticks_.position[k] + beyond - plant_.sensor.position_offset) / plant_.sensor.position_scale;
        const double v = velocity / plant_.sensor.position_scale;
        state = {};
        state.motor = settled(plant_.motor, std::abs(v));
        state.link = settled(plant_.link, std::abs(v));
        if (!plant_.two_mass) {
            state.motor_position = state.followed = q;
            state.motor_velocity = v;
            return;
        }
        const double link = plant_.feedback_link ? q : q / plant_.ratio;
        const double load = load_force(plant_.load, link, ticks_.time[k]);
        // a load that the link's own friction holds leaves open where in its play the link rests: the middle is nearest
        const bool held = plant_.backlash > 0 && std::abs(load) <= plant_.link.coulomb;
        const double stretch = held || rest == Rest::level ? 0 : -load / plant_.stiffness;
        const double play = stretch == 0 ? 0 : std::copysign(0.5 * plant_.backlash, stretch);
        if (plant_.feedback_link) {
            state.link_position = q;
            state.motor_position = plant_.ratio * (q + stretch + play);
            state.link_velocity = v;
            state.motor_velocity = plant_.ratio * v;
        } else {
            state.motor_position = q;
            state.link_position = q / plant_.ratio - stretch - play;
            state.motor_velocity = v;
            state.link_velocity = v / plant_.ratio;
        }
        state.followed = state.link_position;
    }
    double seen_position() const { return plant_.feedback_link ? state.link_position : state.motor_position; }
    double seen_velocity() const { return plant_.feedback_link ? state.link_velocity : state.motor_velocity; }

    /// The effort just after the update at tick k, before the step is taken.
    double effort_now(std::size_t k)
    {
        const double t = ticks_.time[k];
        const bool read_late = plant_.sensor.delay > 0;
        const double arrived = (read_late ? logged_ : held_).mean(t, 1e-9, k);
        const double lagged = read_late ? logged_lagged_ : state.lagged;
        return push(k, plant_.actuator.lag > 0 ? lagged : arrived).at(state.motor_velocity);
    }

    void advance(std::size_t k)
    {
        const double tick = ticks_.step[k], t0 = ticks_.time[k], read_late = plant_.sensor.delay;
        if (tick != tick_) tick_ = tick, parts_ = substeps(plant_, tick);
        const double h = tick / parts_;
        if (drifts_) {
            const double middle = t0 - read_late + 0.5 * tick;
            plant_.motor.coulomb = motor_level_ + drifted(plant_.motor, middle);
            plant_.link.coulomb = link_level_ + drifted(plant_.link, middle);
        }
        if (!ticks_.load.empty()) plant_.load.constant = constant_load_ + ticks_.load[k];
        if (!ticks_.inertia.empty())
            (plant_.two_mass ? plant_.link_inertia : plant_.motor_inertia) = moved_inertia_ * ticks_.inertia[k];
        if (drifts_ || !ticks_.inertia.empty() || h != length_.h) length_ = StepLength(plant_, h);
        const double lag = plant_.actuator.lag;
        const double keep = lag > 0 ? std::exp(-h / lag) : 0, mean_keep = lag > 0 ? lag / h * (1 - keep) : 0;
        const bool steady = plant_.dead_time == 0 && lag == 0 && !plant_.dc_motor();
        Push drive = steady ? push(k, held_.mean(t0, tick, k)) : Push{};
        for (int i = 0; i < parts_; ++i) {
            const double t = t0 + i * h;
            if (!steady) {
                double arrived = held_.mean(t, h, k);
                if (read_late > 0 && lag > 0) {
                    const double at_once = logged_.mean(t, h, k);
                    logged_lagged_ = at_once + (logged_lagged_ - at_once) * keep;
                }
                if (lag > 0) {
                    const double gap = state.lagged - arrived;
                    state.lagged = arrived + gap * keep;
                    arrived += gap * mean_keep;
                }
                drive = push(k, arrived);
            }
            if (plant_.two_mass)
                step_two_mass(plant_, state, drive, t - read_late, length_);
            else
                step_single(plant_, state, drive, t - read_late, length_);
        }
    }

    void correct(double error, double gain_position, double gain_velocity)
    {
        const double dq = gain_position * error / plant_.sensor.position_scale;
        const double dv = gain_velocity * error / plant_.sensor.position_scale;
        if (!plant_.two_mass) {
            state.motor_position += dq;
            state.motor_velocity += dv;
            return;
        }
        const double to_motor = plant_.feedback_link ? plant_.ratio : 1,
                     to_link = plant_.feedback_link ? 1 : 1 / plant_.ratio;
        // inside the play the link flies on its own: an encoder on the motor says nothing about it, and its noise would
        // be fed into a body that nothing calms. In contact it moves along
        const double apart = state.motor_position / plant_.ratio - state.link_position;
        const bool flying = plant_.backlash > 0 && beyond_play(apart, plant_.backlash) == 0;
        state.motor_position += to_motor * dq;
        state.motor_velocity += to_motor * dv;
        if (flying && !plant_.feedback_link) return;
        state.link_position += to_link * dq;
        state.link_velocity += to_link * dv;
    }

  private:
    Push push(std::size_t k, double arrived) const
    {
        if (!ticks_.enabled[k]) return {};
        return push_of(plant_.actuator, arrived, ticks_.supply[k], state.motor_velocity);
    }

    Plant plant_;  ///< with the levels of friction, the load and the inertia of this tick
    const Ticks& ticks_;
    HeldCommand held_;    ///< that moves what is read
    HeldCommand logged_;  ///< behind the effort that is logged
    double logged_lagged_ = 0;
    StepLength length_;
    double motor_level_ = plant_.motor.coulomb, link_level_ = plant_.link.coulomb;
    double constant_load_ = plant_.load.constant;
    double moved_inertia_ = plant_.two_mass ? plant_.link_inertia : plant_.motor_inertia;
    bool drifts_ = plant_.motor.drift != 0 || plant_.link.drift != 0;
    double tick_ = 0;  ///< s, of the last step, in this many parts
    int parts_ = 0;
};

/// Predicts the ticks from this rest.
void predict_from(Rest rest, const Plant& plant, const Ticks& ticks, std::span<const double> command, double omega,
                  Innovation& out)
{
    const std::size_t n = ticks.size();
    out.position.assign(n, not_set);
    out.effort.assign(n, not_set);
    out.velocity.resize(n);
    out.predicted_effort.resize(n);
    if (n == 0) return;
    Mechanics mechanics(plant, ticks, command);
    mechanics.start(0, ticks.initial_velocity, rest);
    double since = 0;  // time since the last correction
    auto restart = ticks.restarts.begin();
    for (std::size_t k = 0; k < n; ++k) {
        if (restart != ticks.restarts.end() && restart->tick == k) {
            mechanics.start(k, restart->velocity);
            ++restart, since = 0;
        }
        if (ticks.logged[k]) {
            const double predicted =
                plant.sensor.position_scale * mechanics.seen_position() + plant.sensor.position_offset;
            const double error = ticks.position[k] - predicted;
            out.position[k] = error;
            const double T = std::min(since, 0.5 / std::max(omega, 1e-9));
            if (k > 0) mechanics.correct(error, 1.6 * omega * T, omega * omega * T);
            since = 0;
        }
        out.velocity[k] = mechanics.seen_velocity();
        out.predicted_effort[k] = mechanics.effort_now(k);
        if (is_set(ticks.effort[k])) out.effort[k] = ticks.effort[k] - out.predicted_effort[k];
        since += ticks.step[k];
        if (k + 1 < n) mechanics.advance(k);
    }
}

/// Which rest predicts the first moments better. A record does not say it, and a link that falls through its play
/// misses by thousands of floors.
Rest rest_at_start(const Plant& plant, const Ticks& ticks, std::span<const double> command)
{
    if (!plant.two_mass || !ticks.at_rest || ticks.size() < 2) return Rest::pressed;
    const double link = plant.feedback_link ? ticks.position[0] : ticks.position[0] / plant.ratio;
    if (load_force(plant.load, link, ticks.time[0]) == 0) return Rest::pressed;
    constexpr double moment = 0.2;  // s
    constexpr double omega = 50;    // rad/s
    std::size_t count = 1;
    while (count < ticks.size() && ticks.time[count] - ticks.time[0] < moment) ++count;
    const Ticks first = first_ticks(ticks, count);
    const auto missed = [&](Rest rest) {
        Innovation innovation;
        predict_from(rest, plant, first, command.first(count), omega, innovation);
        double sum = 0;
        for (double e : innovation.position)
            if (is_set(e)) sum += e * e;
        return sum;
    };
    return missed(Rest::level) < missed(Rest::pressed) ? Rest::level : Rest::pressed;
}

}  // namespace

Trace closed_loop(const Plant& plant, const Ticks& ticks, std::uint64_t seed)
{
    const std::size_t n = ticks.size();
    Trace out;
    for (auto* column :
         {&out.position, &out.velocity, &out.command, &out.effort, &out.true_position, &out.true_velocity})
        column->resize(n);
    if (n == 0) return out;
    SeededNoise noise(seed);
    const Sensor& sensor = plant.sensor;
    Mechanics mechanics(plant, ticks, out.command);
    // where the joint stands at the start is known to a step of its encoder, and in a loop that hunts across the steps
    // two starts end far apart
    const double within_step =
        seed != 0 && sensor.encoder_quantum > 0 ? sensor.encoder_quantum * (SeededNoise(~seed).uniform() - 0.5) : 0;
    mechanics.start(0, ticks.initial_velocity, rest_at_start(plant, ticks, known_command(plant, ticks)), within_step);
    Controller controller(plant);
    for (std::size_t k = 0; k < n; ++k) {
        const double q = mechanics.seen_position();
        double reading = sensor.position_scale * q + sensor.position_offset;
        if (seed != 0) reading += sensor.position_noise * noise();
        if (sensor.encoder_quantum > 0) reading = sensor.encoder_quantum * std::round(reading / sensor.encoder_quantum);
        controller.read(reading, k == 0 ? ticks.step[0] : ticks.step[k - 1], mechanics.seen_velocity());
        out.true_position[k] = q;
        out.true_velocity[k] = mechanics.seen_velocity();
        out.position[k] = reading;
        out.velocity[k] = controller.velocity();
        out.command[k] = controller.command(ticks.reference[k], ticks.reference_rate[k], ticks.added(k));
        out.effort[k] = mechanics.effort_now(k) + (seed != 0 ? sensor.effort_noise * noise() : 0);
        if (k + 1 < n) mechanics.advance(k);
    }
    return out;
}

namespace {

std::vector<double> velocity_between_rows(const Ticks& ticks)
{
    std::vector<double> v = ticks.velocity;
    std::size_t last = 0;
    for (std::size_t k = 1; k < v.size(); ++k) {
        if (!is_set(v[k])) continue;
        for (std::size_t i = last + 1; i < k; ++i)
            v[i] = v[last] + (v[k] - v[last]) * static_cast<double>(i - last) / static_cast<double>(k - last);
        last = k;
    }
    return v;
}

/// Lets the controller follow the measured motion: take(k) after each tick's command.
template <class Take>
void follow_readings(Controller& controller, const Ticks& ticks, Take&& take)
{
    controller.restart(ticks.initial_integral);
    // readings between the rows of a slow log are interpolated: the logged estimate is then the better velocity
    const auto logged_velocity =
        ticks.unseen_between() && ticks.has_velocity ? velocity_between_rows(ticks) : std::vector<double>();
    auto restart = ticks.restarts.begin();
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (restart != ticks.restarts.end() && restart->tick == k) controller.restart(restart->integral), ++restart;
        const double exact = is_set(ticks.velocity[k]) ? ticks.velocity[k]
                             : k == 0                  ? 0
                                      : (ticks.position[k] - ticks.position[k - 1]) / ticks.step[k - 1];
        controller.read(ticks.position[k], k == 0 ? ticks.step[0] : ticks.step[k - 1], exact);
        if (!logged_velocity.empty()) controller.believe(logged_velocity[k]);
        take(k, controller.command(ticks.reference[k], ticks.reference_rate[k], ticks.added(k)));
    }
}

}  // namespace

std::vector<double> command_of(const Plant& plant, const Ticks& ticks)
{
    std::vector<double> command(ticks.size());
    Controller controller(plant);
    follow_readings(controller, ticks, [&](std::size_t k, double c) { command[k] = c; });
    return command;
}

std::vector<double> integral_of(const Joint& joint, const Ticks& ticks)
{
    Controller controller(joint);
    if (!controller.integrates() || !ticks.has_reference) return {};
    std::vector<double> before(ticks.size() + 1, ticks.initial_integral);
    follow_readings(controller, ticks, [&](std::size_t k, double) { before[k + 1] = controller.integral(); });
    before.pop_back();
    return before;
}

std::vector<double> known_command(const Plant& plant, const Ticks& ticks)
{
    if (ticks.source == CommandSource::logged && ticks.ticks_per_row == 1 && !ticks.lost) return ticks.command;
    std::vector<double> command = ticks.source == CommandSource::none ? std::vector<double>(ticks.size(), 0.0)
                                  : ticks.has_reference               ? command_of(plant, ticks)
                                                                      : ticks.command;
    double held = 0;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (is_set(ticks.command[k]))
            held = command[k] = ticks.command[k];
        else if (!is_set(command[k]))
            command[k] = held;
    }
    return command;
}

void predict(const Plant& plant, const Ticks& ticks, std::span<const double> command, double omega, Innovation& out)
{
    predict_from(rest_at_start(plant, ticks, command), plant, ticks, command, omega, out);
}

namespace {

/// e_k = n_k − q̂_k with q̂, v̂ driven by e, for one reading that is off by one; `take` gets e and v̂.
template <class Take>
void respond(double omega, double step, Take&& take)
{
    const double T = std::min(step, 0.5 / std::max(omega, 1e-9));
    const double g = 1.6 * omega * T, k = omega * omega * T;
    double q = 0, v = 0;
    for (int i = 0; i < 100000; ++i) {
        const double e = (i == 0 ? 1 : 0) - q;
        q += g * e;
        v += k * e;
        take(e, v);
        q += step * v;
        if (i > 10 && std::abs(q) + std::abs(v) * step < 1e-9) break;
    }
}

}  // namespace

double noise_amplification(double omega, double step)
{
    double sum = 0;
    respond(omega, step, [&](double e, double) { sum += e * e; });
    return sum;
}

double velocity_noise_amplification(double omega, double step)
{
    double sum = 0;
    respond(omega, step, [&](double, double v) { sum += v * v; });
    return sum;
}

std::vector<double> innovation_response(double omega, double step)
{
    std::vector<double> response;
    respond(omega, step, [&](double e, double) { response.push_back(e); });
    return response;
}

}  // namespace stickslip::gap
