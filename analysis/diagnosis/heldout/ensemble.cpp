// In one file: noisy runs of one joint, and what a record differs from them by: floor and gap are counted alike.
#include "analysis/diagnosis/heldout/ensemble.h"

#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/fit/jumps.h"
#include "analysis/diagnosis/fit/reference.h"
#include "analysis/diagnosis/policy/ladder.h"
#include "analysis/joint/gains.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stickslip::gap {
namespace {

constexpr int closed_loop_runs = 4;

/// A simulated run through the log and back onto the clock: between the rows of a slow log nothing is known of it
/// either. What is known of the surroundings is known of it, too, tick by tick.
Ticks logged_again(const Trace& trace, const Ticks& t, const Joint& joint)
{
    Record log;
    log.name = t.name;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (!t.logged[k]) continue;
        log.time.push_back(t.time[k]);
        if (!t.reference_rebuilt) {
            log.reference_position.push_back(t.reference[k]);
            log.reference_velocity.push_back(t.reference_rate[k]);
        }
        log.position.push_back(trace.position[k]);
        if (is_set(t.velocity[k])) log.velocity.push_back(trace.velocity[k]);
        if (is_set(t.command[k])) log.effort_command.push_back(trace.command[k]);
        if (is_set(t.effort[k])) log.effort_measured.push_back(trace.effort[k]);
        if (is_set(t.supply[k])) log.supply_voltage.push_back(t.supply[k]);
        log.torque_enable.push_back(t.enabled[k]);
    }
    log.at_rest_at_start = t.at_rest, log.began = t.began;
    Ticks again = on_clock(log, joint);
    again.feed_forward = t.feed_forward, again.load = t.load, again.inertia = t.inertia;
    again.load_error = t.load_error, again.straight_command = t.straight_command;
    return again;
}

using Misfits = std::array<Misfit, levels.size()>;

/// The misfits of one noisy run of a joint to its own prediction.
Misfits misfits_of_run(Case c, std::uint64_t seed)
{
    const bool without_reference = c.ticks.reference_rebuilt;
    c.ticks = logged_again(simulate_closed_loop(flatten(c.joint), c.ticks, seed), c.ticks, c.joint);
    if (without_reference) rebuild_reference(c, c.joint.control.effort_limit);
    std::vector<Case> one{std::move(c)};
    settle_jumps(one, {}, {});
    Misfits misfits;
    for (std::size_t l = 0; l < levels.size(); ++l) misfits[l] = evaluate(one, {}, {}, levels[l]).records[0];
    return misfits;
}

}  // namespace

NoiseSpread spread_of(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                      int runs, const ParallelFor& parallel)
{
    NoiseSpread spread;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        spread.mean[l].assign(cases.size(), {1, 1});
        spread.deviation[l].assign(cases.size(), {0, 0});
    }
    for (const auto& c : cases)
        if (!c.ticks.has_reference) return spread;
    spread.simulated = true;
    const std::size_t n = static_cast<std::size_t>(runs);
    std::vector<Misfits> all(cases.size() * n);
    parallel(all.size(), [&](std::size_t task) {
        Case c = cases[task / n];
        c.joint = edited(c.joint, candidate, si, c.number);
        all[task] = misfits_of_run(std::move(c), 101 + task);
    });
    for (std::size_t i = 0; i < cases.size(); ++i)
        for (std::size_t l = 0; l < levels.size(); ++l) {
            Misfit sum{0, 0}, square{0, 0};
            for (std::size_t r = 0; r < n; ++r) {
                const auto& m = all[i * n + r][l];
                sum.position += m.position, sum.effort += m.effort;
                square.position += m.position * m.position, square.effort += m.effort * m.effort;
            }
            const double count = static_cast<double>(n);
            auto& mean = spread.mean[l][i];
            mean = {sum.position / count, sum.effort / count};
            spread.deviation[l][i] = {std::sqrt(std::max(0.0, square.position / count - mean.position * mean.position)),
                                      std::sqrt(std::max(0.0, square.effort / count - mean.effort * mean.effort))};
        }
    return spread;
}

bool within(const NoiseSpread& spread, const std::array<Evaluation, levels.size()>& evaluation, std::size_t levels_used)
{
    for (std::size_t l = 0; l < levels_used; ++l)
        for (std::size_t i = 0; i < evaluation[l].records.size(); ++i) {
            const auto &m = evaluation[l].records[i], &mean = spread.mean[l][i], &deviation = spread.deviation[l][i];
            if (m.position > std::max(1.0, mean.position) + policy::slack_of_floor +
                                 policy::deviations_of_floor * deviation.position)
                return false;
            if (m.effort >
                std::max(1.0, mean.effort) + policy::slack_of_floor + policy::deviations_of_floor * deviation.effort)
                return false;
        }
    return true;
}

CommandUnit command_unit(const Joint& joint)
{
    const double gain = joint.actuator.kind == ActuatorKind::effort ? joint.actuator.effort_gain : 1;
    return {gain, std::string(unit_of(Quantity::command, units_of(joint)))};
}

namespace {

using Inside = std::function<bool(std::size_t tick)>;

/// Without a reference the loop cannot be simulated: what a slow observer leaves of position and effort, with the
/// prediction floor as the noise floor. `shown` gets what it predicts.
std::vector<SignalSquares> predicted_squares(const Case& c, const Joint& joint, const Inside& inside, Trace* shown)
{
    const Plant plant = flatten(joint);
    const Ticks& t = c.ticks;
    Innovation innovation;
    predict(plant, t, known_command(plant, t), slow_observer, innovation);
    if (shown) {
        *shown = {};
        shown->predicted = true;
        double missed = 0;  // between rows as at the last one
        for (std::size_t k = 0; k < t.size(); ++k) {
            if (t.logged[k]) missed = innovation.position[k];
            shown->position.push_back(t.position[k] - missed);
        }
        shown->effort = innovation.predicted_effort;
    }
    SignalSquares position{"position (predicted)",
                           std::string(unit_of(Quantity::position, Units(joint.mechanism.motion)))};
    SignalSquares effort{"effort_measured", std::string(unit_of(Quantity::effort, Units(joint.mechanism.motion)))};
    double n = 0;
    for (std::size_t k = 0; k < t.size(); ++k)
        if (inside(k)) {
            position.difference += innovation.position[k] * innovation.position[k];
            if (c.effort_sigma > 0) effort.difference += innovation.effort[k] * innovation.effort[k];
            n += 1;
        }
    position.difference /= std::max(n, 1.0);
    position.floor = std::pow(reading_floor(c, slow_observer), 2) * noise_amplification(slow_observer, c.row_step);
    effort.difference /= std::max(n, 1.0);
    effort.floor = std::pow(effort_floor(c, slow_observer), 2);
    position.rows = effort.rows = n;
    std::vector<SignalSquares> squares{position};
    if (c.effort_sigma > 0) squares.push_back(effort);
    return squares;
}

/// A signal against the same of noisy runs; `rows` 0 where it was not logged.
SignalSquares simulated_squares(const Case& c, const std::vector<double>& measured, const std::vector<Trace>& traces,
                                std::vector<double> Trace::*column, const Inside& inside)
{
    const Ticks& t = c.ticks;
    const int runs = static_cast<int>(traces.size());
    SignalSquares s;
    double n = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (!inside(k) || !is_set(measured[k])) continue;
        // while the drive is off nothing came of the command, and nothing can be learnt of it
        if (column == &Trace::command && !t.enabled[k]) continue;
        double mean = 0, square = 0;
        for (const auto& trace : traces) {
            const double x = (trace.*column)[k];
            mean += x / runs;
            square += x * x / runs;
            s.difference += (measured[k] - x) * (measured[k] - x) / runs;
        }
        // two independent runs differ by twice the variance
        s.floor += 2 * std::max(0.0, square - mean * mean) * runs / (runs - 1.0);
        n += 1;
    }
    s.rows = n;
    return s;
}

/// A mean square of the readings' error, in the position and, as k_p passes it on, in the command.
void raise_floor_of_readings(const Case& c, const Joint& joint, double reading, std::vector<SignalSquares>& squares)
{
    const double passed_on = command_unit(c.joint).factor * gains_of(joint.control).k_p;
    for (auto& s : squares) {
        if (s.signal == "position") s.floor = std::max(s.floor, reading);
        if (s.signal == "effort_command") s.floor = std::max(s.floor, passed_on * passed_on * reading);
    }
}

}  // namespace

std::vector<SignalSquares> compare(const Case& c, const Joint& joint, int runs, double from, double to, Trace* first)
{
    const Ticks& t = c.ticks;
    const Inside inside = [&](std::size_t k) {
        return t.logged[k] && t.time[k] >= from && t.time[k] < to && (t.judged.empty() || t.judged[k] != 0);
    };
    if (!t.has_reference) return predicted_squares(c, joint, inside, first);
    const Plant plant = flatten(joint);
    std::vector<Trace> traces;
    for (int r = 0; r < runs; ++r) traces.push_back(simulate_closed_loop(plant, t, 1 + static_cast<std::uint64_t>(r)));
    std::vector<SignalSquares> squares;
    const auto add = [&](const char* name, std::string unit, const std::vector<double>& measured,
                         std::vector<double> Trace::*column, double factor = 1) {
        SignalSquares s = simulated_squares(c, measured, traces, column, inside);
        if (s.rows == 0) return;
        s.signal = name, s.unit = std::move(unit);
        s.difference *= factor * factor / s.rows;
        s.floor *= factor * factor / s.rows;
        squares.push_back(std::move(s));
    };
    const Motion motion = joint.mechanism.motion;
    const CommandUnit command = command_unit(c.joint);
    add("position", std::string(unit_of(Quantity::position, Units(motion))), t.position, &Trace::position);
    add("effort_command", command.unit, t.command, &Trace::command, command.factor);
    if (c.effort_sigma > 0)
        add("effort_measured", std::string(unit_of(Quantity::effort, Units(motion))), t.effort, &Trace::effort);
    // the noise of a reading is there, simulated or not, and k_p passes it on; it is that of the sensor in question:
    // the steps of a coarser encoder are a gap. Where no noise is documented, nothing below those steps is known
    const double sigma = c.noise_documented ? reading_sigma(joint.sensor, span_of(t.position)) : c.sigma;
    raise_floor_of_readings(c, joint, 2 * sigma * sigma * 0.25, squares);
    if (first && !traces.empty()) *first = std::move(traces[0]);
    return squares;
}

void raise_floor_to_steps(const Case& c, const Joint& joint, double finer, std::vector<SignalSquares>& squares)
{
    const Ticks& t = c.ticks;
    if (!t.has_reference) return;
    Joint fine = joint;
    fine.sensor.encoder_quantum = finer;
    constexpr std::uint64_t seed = 1;  // the same noise in both
    const Trace coarse = simulate_closed_loop(flatten(joint), t, seed);
    const Trace smooth = simulate_closed_loop(flatten(fine), t, seed);
    // what the steps make of one signal is independent of what they make of another joint's
    const auto twice = [&](std::vector<double> Trace::*column) {
        double sum = 0, rows = 0;
        for (std::size_t k = 0; k < t.size(); ++k)
            if (t.logged[k]) sum += 2 * std::pow((coarse.*column)[k] - (smooth.*column)[k], 2), rows += 1;
        return sum / std::max(rows, 1.0);
    };
    const double command = command_unit(c.joint).factor;
    for (auto& s : squares) {
        if (s.signal == "position") s.floor = std::max(s.floor, twice(&Trace::position));
        if (s.signal == "effort_command") s.floor = std::max(s.floor, command * command * twice(&Trace::command));
        if (s.signal == "effort_measured") s.floor = std::max(s.floor, twice(&Trace::effort));
    }
}

namespace {

/// A simulation that is unstable or chaotic at its rate differs from itself by a good part of the motion: anything
/// would then be within what it does.
bool own_runs_agree(const std::vector<SignalSquares>& signals, double span, double sigma)
{
    for (const auto& s : signals)
        if (s.signal == "position" &&
            !(std::sqrt(s.floor / 2) < std::max(policy::own_part * span, policy::own_readings * sigma)))
            return false;
    return true;
}

}  // namespace

bool closed_loop_at_floor(const std::vector<Case>& cases, const Candidate& candidate, const std::vector<double>& si,
                          const ParallelFor& parallel)
{
    for (const auto& c : cases)
        if (!c.ticks.has_reference) return false;
    std::vector<int> fine(cases.size(), 0);
    parallel(cases.size(), [&](std::size_t i) {
        const auto signals = compare(cases[i], edited(cases[i].joint, candidate, si, cases[i].number), closed_loop_runs,
                                     -infinity, infinity);
        fine[i] = own_runs_agree(signals, span_of(cases[i].ticks.position), cases[i].sigma) &&
                  std::all_of(signals.begin(), signals.end(),
                              [](const auto& s) { return s.difference <= policy::slack_of_runs * s.floor; });
    });
    return std::all_of(fine.begin(), fine.end(), [](int yes) { return yes != 0; });
}

}  // namespace stickslip::gap
