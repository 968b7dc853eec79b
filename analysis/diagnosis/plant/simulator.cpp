#include "analysis/diagnosis/plant/simulator.h"

#include "analysis/diagnosis/plant/controller.h"
#include "analysis/diagnosis/plant/runs.h"
#include "analysis/numerics/seeded_noise.h"

#include <cmath>

namespace stickslip::gap {

namespace {

/// The load that may have acted: a computed one is wrong by as much either way.
Ticks with_load_error(Ticks ticks, std::uint64_t seed)
{
    const double sign = seed % 2 == 1 ? 1 : -1;
    for (std::size_t k = 0; k < ticks.load.size(); ++k) ticks.load[k] += sign * ticks.load_error[k];
    ticks.load_error.clear();
    return ticks;
}

}  // namespace

Trace simulate_closed_loop(const Plant& plant, const Ticks& ticks, std::uint64_t seed)
{
    if (seed != 0 && !ticks.load_error.empty() && !ticks.load.empty())
        return simulate_closed_loop(plant, with_load_error(ticks, seed), seed);
    const std::size_t n = ticks.size();
    Trace out;
    for (auto* column :
         {&out.position, &out.velocity, &out.command, &out.effort, &out.true_position, &out.true_velocity})
        column->resize(n);
    if (n == 0) return out;
    SeededNoise noise(seed);
    const double kept = ticks.noise_kept, fresh = std::sqrt(1 - kept * kept);
    double off = seed != 0 ? noise() : 0;  // by how much a reading is, in units of its noise
    const Sensor& sensor = plant.sensor;
    Mechanics<lanes::Pack<1, 1>> mechanics(kind_of(plant, ticks));
    // a command that is not held goes on as it went from the tick before, until the next one is known
    std::vector<double> drive(n);
    mechanics.load(0, plant, ticks, ticks.straight_command ? drive : out.command, 0);
    // where the joint stands at the start is known to a step of its encoder, and in a loop that hunts across the steps
    // two starts end far apart
    SeededNoise at_start(~seed);
    const double within_step =
        seed != 0 && sensor.encoder_quantum > 0 ? sensor.encoder_quantum * (at_start.uniform() - 0.5) : 0;
    const double velocity =
        ticks.initial_velocity + (seed != 0 && !ticks.at_rest ? ticks.initial_velocity_error * at_start() : 0);
    mechanics.start(0, velocity, rest_at_start(plant, ticks), within_step);
    Controller controller(plant);
    if (ticks.at_rest)
        controller.restart(ticks.initial_integral);
    else
        controller.restart_moving(mechanics.reading()[0], velocity, ticks.step[0], ticks.initial_integral);
    for (std::size_t k = 0; k < n; ++k) {
        double reading = mechanics.reading()[0];
        if (seed != 0) reading += sensor.position_noise * off;
        if (sensor.encoder_quantum > 0) reading = sensor.encoder_quantum * std::round(reading / sensor.encoder_quantum);
        out.true_position[k] = mechanics.seen_position()[0];
        out.true_velocity[k] = mechanics.seen_velocity()[0];
        controller.read(reading, k == 0 ? ticks.step[0] : ticks.step[k - 1], out.true_velocity[k]);
        out.position[k] = reading;
        out.velocity[k] = controller.velocity();
        out.command[k] = controller.command(ticks.reference[k], ticks.reference_rate[k], ticks.added(k), ticks.time[k]);
        drive[k] = out.command[k];
        if (k + 1 < n) drive[k + 1] = k == 0 ? drive[k] : 2 * drive[k] - drive[k - 1];
        if (k == 0 && !ticks.at_rest) mechanics.hold(out.command[0]);
        out.effort[k] = mechanics.effort_now()[0] + (seed != 0 ? sensor.effort_noise * noise() : 0);
        if (k + 1 < n) mechanics.advance();
        if (seed != 0) off = kept * off + fresh * noise();
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
        ticks.velocity_believed() && !ticks.noisy_rows ? velocity_between_rows(ticks) : std::vector<double>();
    auto restart = ticks.restarts.begin();
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (restart != ticks.restarts.end() && restart->tick == k) controller.restart(restart->integral), ++restart;
        const double exact = is_set(ticks.velocity[k]) ? ticks.velocity[k]
                             : k == 0                  ? 0
                                      : (ticks.position[k] - ticks.position[k - 1]) / ticks.step[k - 1];
        controller.read(ticks.position[k], k == 0 ? ticks.step[0] : ticks.step[k - 1], exact);
        if (!logged_velocity.empty()) controller.believe(logged_velocity[k]);
        take(k, controller.command(ticks.reference[k], ticks.reference_rate[k], ticks.added(k), ticks.time[k]));
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

namespace {

/// Whether every tick's command was logged.
bool logged_throughout(const Ticks& ticks)
{
    return ticks.source == CommandSource::measured ||
           (ticks.source == CommandSource::logged && ticks.ticks_per_row == 1 && !ticks.lost);
}

}  // namespace

std::span<const double> known_command(const Plant& plant, const Ticks& ticks, std::vector<double>& room)
{
    if (logged_throughout(ticks)) return ticks.command;
    room = known_command(plant, ticks);
    return room;
}

std::vector<double> known_command(const Plant& plant, const Ticks& ticks)
{
    if (logged_throughout(ticks)) return ticks.command;
    std::vector<double> command = ticks.source == CommandSource::none ? std::vector<double>(ticks.size(), 0.0)
                                  : ticks.has_reference               ? command_of(plant, ticks)
                                                                      : ticks.command;
    double held = 0;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (is_set(ticks.command[k]) && !ticks.noisy_rows)
            held = command[k] = ticks.command[k];
        else if (!is_set(command[k]))
            command[k] = held;
    }
    return command;
}

namespace {

/// e_k = n_k − q̂_k with q̂, v̂ driven by e, for one reading that is off by one or a joint that is faster by `kick`;
/// `take` gets e and v̂.
template <class Take>
void respond(double omega, double step, Take&& take, double reading = 1, double kick = 0)
{
    const double T = std::min(step, 0.5 / std::max(omega, 1e-9));
    const double g = 1.6 * omega * T, k = omega * omega * T;
    constexpr double settled = 1e-9;  // numerical: of the step that is answered
    double q = 0, v = -kick;
    for (int i = 0; i < 100000; ++i) {
        const double e = (i == 0 ? reading : 0) - q;
        q += g * e;
        v += k * e;
        take(e, v);
        q += step * v;
        if (i > 10 && std::abs(q) + std::abs(v) * step < settled) break;
    }
}

}  // namespace

double noise_amplification(double omega, double step)
{
    double sum = 0;
    respond(omega, step, [&](double e, double) { sum += e * e; });
    return sum;
}

double kick_amplification(double omega, double step)
{
    double sum = 0;
    respond(
        omega, step, [&](double e, double) { sum += e * e; }, 0, 1);
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
