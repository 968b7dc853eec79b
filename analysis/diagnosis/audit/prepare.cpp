// In one file: a record becomes a case: its noise, its start and its scales rely on each other.
#include "analysis/diagnosis/audit/prepare.h"

#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/effort_drive.h"
#include "analysis/diagnosis/records/even_clock.h"
#include "analysis/joint/parameters.h"
#include "analysis/results/cannot_answer.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

double percentile(std::vector<double> values, double part)
{
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double rms(const std::vector<double>& values)
{
    double sum = 0;
    std::size_t n = 0;
    for (double v : values)
        if (std::isfinite(v)) sum += v * v, ++n;
    return n ? std::sqrt(sum / static_cast<double>(n)) : 0;
}

/// The readings, with holes where rows were lost.
std::vector<double> on_grid(const Ticks& t)
{
    std::vector<double> readings;
    for (std::size_t k = 0; k < t.size(); k += static_cast<std::size_t>(t.ticks_per_row))
        readings.push_back(t.logged[k] ? t.position[k] : not_set);
    return readings;
}

/// Noise of the measured effort: what is left of it once the effort is taken away that the command asks for. That a
/// noisy encoder makes the command noisy, too, is no noise of this sensor.
double effort_noise_of(const Case& c, const std::vector<double>& measured)
{
    const Plant plant = flatten(c.joint);
    Innovation innovation;
    predict(plant, c.ticks, known_command(plant, c.ticks), levels[1], innovation);
    std::vector<double> left;
    for (std::size_t k = 0; k < c.ticks.size(); ++k)
        if (c.ticks.logged[k] && std::isfinite(innovation.effort[k])) left.push_back(innovation.effort[k]);
    return std::min(noise_of(measured), noise_of(left));
}

/// Model noise that no two integrators agree on, as a part of the span of a signal.
constexpr double numerical_part = 2e-7;
/// The same for an effort: a lag or a delay is written down in slightly different ways.
constexpr double effort_part = 1e-3;

}  // namespace

double noise_of(const std::vector<double>& y)
{
    if (y.size() < 8) return 0;
    std::vector<double> third;
    for (std::size_t k = 3; k < y.size(); ++k)
        if (const double d = std::abs(y[k] - 3 * y[k - 1] + 3 * y[k - 2] - y[k - 3]); std::isfinite(d))
            third.push_back(d);
    if (third.empty()) return 0;
    const auto rms_below = [&](double limit) {
        double sum = 0, n = 0;
        for (double d : third)
            if (d < limit) sum += d * d, n += 1;
        return n > 0 ? std::sqrt(sum / n) : 0;
    };
    // impacts and steps are rare and large, and are no noise; where most differences vanish all that is left is steps
    constexpr double normal = 1.4826, far = 5;
    double spread = normal * percentile(third, 0.5);
    if (spread == 0) return rms_below(infinity) / std::sqrt(20.0);
    for (int i = 0; i < 5; ++i) spread = rms_below(far * spread);
    return spread / std::sqrt(20.0);
}

double span_of(const std::vector<double>& values)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return values.empty() ? 0 : *high - *low;
}

double reading_sigma(const Sensor& sensor, double span)
{
    const double numerical = numerical_part * span;
    return std::sqrt(sensor.position_noise * sensor.position_noise +
                     sensor.encoder_quantum * sensor.encoder_quantum / 12 + numerical * numerical);
}

namespace {

/// Mean square of what the first rows are off the prediction, in units of a reading's.
double missed_at_start(const Case& c)
{
    constexpr std::size_t rows = 10;
    constexpr double omega = 20;  // rad/s: hardly corrects within these rows
    std::size_t ticks = 0, seen = 0;
    while (ticks < c.ticks.size() && seen < rows) seen += c.ticks.logged[ticks++];
    const Ticks first = first_ticks(c.ticks, ticks);
    const Plant plant = flatten(c.joint);
    Innovation innovation;
    predict(plant, first, known_command(plant, first), omega, innovation);
    double sum = 0;
    for (std::size_t k = 0; k < ticks; ++k)
        if (first.logged[k]) sum += innovation.position[k] * innovation.position[k];
    return sum / (static_cast<double>(rows) * c.sigma * c.sigma);
}

/// Cut from a longer one, a record starts in motion. It is taken to, where that predicts its first rows and rest does
/// not.
void find_start(Case& c, std::vector<Note>& notes)
{
    // mean square; of that of rest: an unmodelled force that sets a joint in motion leaves a sixth
    constexpr double clearly = 25, much_better = 0.05;
    const double at_rest = missed_at_start(c);
    if (!(at_rest > clearly)) return;
    Case moving = c;
    moving.ticks.at_rest = false, moving.ticks.initial_velocity = velocity_at_start(c.ticks);
    if (!(missed_at_start(moving) < much_better * at_rest)) return;
    c.ticks = std::move(moving.ticks);
    notes.push_back({Note::Code::starts_moving, c.ticks.name});
}

/// Noise of the effort that drives the joint.
double drive_noise(const Case& c, const Record& record, double doubt, std::vector<Note>& notes)
{
    if (c.joint.sensor.effort_noise > 0) return c.joint.sensor.effort_noise;
    notes.push_back({Note::Code::no_documented_effort_noise, record.name});
    return doubt * noise_of(record.effort_measured);
}

/// What the error of a known load adds to the predictions: those with it against those without.
void measure_load_error(Case& c)
{
    if (c.ticks.load_error.empty() || c.ticks.load.empty()) return;
    const Plant plant = flatten(c.joint);
    Ticks wrong = c.ticks;
    for (std::size_t k = 0; k < wrong.size(); ++k) wrong.load[k] += wrong.load_error[k];
    const auto command = known_command(plant, c.ticks);
    for (std::size_t l = 0; l < levels.size(); ++l) {
        Innovation right, off;
        predict(plant, c.ticks, command, levels[l], right);
        predict(plant, wrong, command, levels[l], off);
        std::vector<double> difference;
        for (std::size_t k = 0; k < c.ticks.size(); ++k)
            if (c.ticks.logged[k]) difference.push_back(off.position[k] - right.position[k]);
        c.load_sigma[l] = rms(difference);
    }
}

Case prepare_with_effort(const Record& record, const Joint& joint, std::vector<Note>& notes)
{
    Case c;
    c.joint = joint;
    c.ticks = on_clock(record, c.joint);
    if (c.ticks.source == CommandSource::measured) c.joint = behind_its_effort(joint);
    c.supply_logged = !record.supply_voltage.empty();
    for (std::size_t k = 0, row = 0; k < c.ticks.size() && !record.temperature.empty(); ++k) {
        if (k > 0 && c.ticks.logged[k]) ++row;
        c.temperature.push_back(record.temperature[row]);
    }
    const auto rows = static_cast<double>(std::max<std::size_t>(record.rows(), 2));
    c.row_step = c.ticks.duration() / (rows - 1);
    const double estimated = noise_of(on_grid(c.ticks)), span = span_of(record.position);
    c.sigma = reading_sigma(c.joint.sensor, span);
    const bool documented = c.joint.sensor.position_noise > 0 || c.joint.sensor.encoder_quantum > 0;
    c.noise_documented = documented;
    // a grid that shows in the readings makes differences of its own: the audit names it, noise must not stand in for
    // it
    Sensor gridded = c.joint.sensor;
    const double grid = grid_of(record.position);
    const bool coarser = coarser_grid(grid, c.joint.sensor);
    if (coarser) gridded.encoder_quantum = grid;
    // a documented noise is used unless it is clearly too small, the more so where rounding in the loop shakes the
    // joint; a step of the encoder alone says nothing of noise
    const double believed = c.joint.sensor.position_noise > 0 ? coarser ? 2 : 1.25 : 1.02;
    if (!documented || estimated > believed * reading_sigma(gridded, span)) {
        notes.push_back(
            {documented ? Note::Code::noisier_than_documented : Note::Code::no_documented_noise, record.name});
        c.sigma = std::max(c.sigma, estimated);
        // what rounding adds is in the estimate, and a simulated reading will be rounded again
        const double rounding = gridded.encoder_quantum / std::sqrt(12.0);
        const double white = std::sqrt(std::max(0.0, estimated * estimated - rounding * rounding));
        c.joint.sensor.position_noise = std::max(c.joint.sensor.position_noise, white);
    }
    // what the unlogged commands of a slow log were is known up to the noise that the loop feeds through
    const bool unknown_between = c.ticks.unseen_between() && is_set(c.joint.control.period);
    const double command_noise =
        unknown_between ? noise_of_command(c.joint.control, c.sigma) * std::abs(c.joint.actuator.effort_gain) : 0;
    // an estimate that is a little low would make a gap of plain noise
    constexpr double doubt = 1.03;
    if (c.ticks.source == CommandSource::measured) c.drive_sigma = drive_noise(c, record, doubt, notes);
    if (c.ticks.has_effort) {
        const double range = rms(record.effort_measured);
        double sigma = c.joint.sensor.effort_noise;
        if (sigma == 0) {
            sigma = effort_noise_of(c, record.effort_measured);
            c.joint.sensor.effort_noise = sigma;
            sigma *= doubt;
            notes.push_back({Note::Code::no_documented_effort_noise, record.name});
        }
        c.effort_sigma =
            std::hypot(sigma, effort_part * range, c.joint.actuator.kind == ActuatorKind::effort ? command_noise : 0);
    }
    if (!record.at_rest_at_start) find_start(c, notes);
    measure_load_error(c);
    return c;
}

}  // namespace

double noise_of_command(const Control& control, double reading)
{
    const double rate = std::sqrt(2.0) / (control.period + control.velocity_estimate.tau);
    return reading * std::hypot(control.k_p, control.k_v * rate);
}

Joint joint_in(const Record& record, const Joint& nominal)
{
    Joint joint = nominal;
    for (const auto& [path, value] : record.overrides) {
        double* number = find_parameter(joint, path);
        if (!number) throw CannotAnswer(CannotAnswer::Why::no_parameter, record.name, path);
        *number = value;
    }
    return joint;
}

Case prepare(const Record& stamped, const Joint& nominal, std::vector<Note>& notes)
{
    const Joint joint = joint_in(stamped, nominal);
    Record record = stamped;
    if (auto even = is_set(joint.control.period) ? even_times(stamped.time, joint.control.period) : std::nullopt) {
        record.time = std::move(*even);
        notes.push_back({Note::Code::scattered_stamps, record.name});
    }
    return prepare_with_effort(with_effort_of_current(std::move(record), joint), joint, notes);
}

void share_noise(std::vector<Case>& cases, const Sensor& documented, std::vector<Note>& notes)
{
    constexpr double seldom = 0.5;  // of a step: what moves less than that is seen only in passing
    const double step = documented.encoder_quantum;
    double noise = 0, sigma = 0;
    for (const auto& c : cases) {
        noise = std::max(noise, c.joint.sensor.position_noise), sigma = std::max(sigma, c.sigma);
        if (c.joint.sensor.encoder_quantum != step) return;
    }
    if (documented.position_noise > 0 || sigma >= seldom * step) return;
    for (auto& c : cases) {
        if (c.sigma < sigma) notes.push_back({Note::Code::noise_of_noisiest, c.ticks.name});
        c.joint.sensor.position_noise = noise, c.sigma = sigma;
    }
}

Scales scales_of(const std::vector<Case>& cases)
{
    Scales s;
    double effort = 0, velocity = 0, position = 0, tick = 0, duration = 0, command = 0;
    bool peaked = false;
    for (const auto& c : cases) {
        const Plant plant = flatten(c.joint);
        const auto known = known_command(plant, c.ticks);
        Innovation innovation;
        predict(plant, c.ticks, known, levels[1], innovation);
        std::vector<double> speeds;
        for (double v : innovation.velocity) speeds.push_back(std::isfinite(v) ? std::abs(v) : 0);
        velocity = std::max(velocity, percentile(speeds, 0.95));
        effort = std::max(effort, c.ticks.has_effort ? rms(c.ticks.effort) : rms(innovation.predicted_effort));
        for (double e : c.ticks.has_effort ? c.ticks.effort : innovation.predicted_effort)
            if (std::isfinite(e)) s.peak_effort = std::max(peaked ? s.peak_effort : 0, std::abs(e)), peaked = true;
        position = std::max(position, span_of(c.ticks.position));
        tick = std::max(tick, is_set(c.joint.control.period) ? c.joint.control.period : c.row_step);
        duration = std::max(duration, c.ticks.duration());
        for (double u : known) command = std::max(command, std::abs(u));
        s.inertia = plant.driven_inertia();
        Joint copy = c.joint;
        const Friction& main = main_friction(copy);
        s.load = {plant.ratio, plant.link_per_seen()};
        s.friction = &main == &copy.frictions.link ? s.load : Reflected{1, plant.motor_per_seen()};
        s.coulomb = coulomb_level(main) / s.friction.effort;
        if (is_set(c.joint.actuator.supply_voltage)) s.supply = c.joint.actuator.supply_voltage;
    }
    constexpr double least = 1e-12;
    s.effort = std::max({effort, s.coulomb, least});
    s.velocity = std::max(velocity, least);
    s.position = std::max(position, least);
    s.tick = tick;
    s.duration = std::max(duration, tick);
    s.command = std::max(command, least);
    return s;
}

}  // namespace stickslip::gap
