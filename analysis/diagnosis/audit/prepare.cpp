#include "analysis/diagnosis/audit/prepare.h"

#include "analysis/diagnosis/audit/audit.h"
#include "analysis/diagnosis/audit/effort_drive.h"
#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/audit/start.h"
#include "analysis/diagnosis/policy/records.h"
#include "analysis/diagnosis/records/even_clock.h"
#include "analysis/joint/parameters.h"
#include "analysis/numerics/statistics.h"
#include "analysis/results/cannot_answer.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

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

/// Noise of the effort that drives the joint.
double drive_noise(const Case& c, const Record& record, std::vector<Note>& notes)
{
    if (c.joint.sensor.effort_noise > 0) return c.joint.sensor.effort_noise;
    notes.push_back({Note::Code::no_documented_effort_noise, record.name});
    return policy::doubted_estimate * noise_of(record.effort_measured);
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

/// Noise of a reading, as documented or as estimated.
void find_reading_noise(Case& c, const Record& record, std::vector<Note>& notes)
{
    const auto readings = on_grid(c.ticks);
    const double estimated = noise_of(readings), span = span_of(record.position);
    const ReadingNoise found = noise_with_memory(readings);
    c.ticks.noise_kept = std::pow(found.kept, 1.0 / c.ticks.ticks_per_row);
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
    const double believed = !(c.joint.sensor.position_noise > 0) ? policy::noise_of_step
                            : coarser                            ? policy::noise_beside_grid
                                                                 : policy::noise_believed;
    if (!documented || estimated > believed * reading_sigma(gridded, span)) {
        notes.push_back(
            {documented ? Note::Code::noisier_than_documented : Note::Code::no_documented_noise, record.name});
        // slow motion over coarse steps has no third differences, and no noise to be seen: its readings are off by the
        // rounding all the same, be it the encoder's or the file's
        const double rounding = gridded.encoder_quantum / std::sqrt(12.0);
        c.sigma = std::max({c.sigma, found.sigma, documented ? 0 : rounding});
        // what rounding adds is in the estimate, and a simulated reading will be rounded again
        const double own = std::sqrt(std::max(0.0, found.sigma * found.sigma - rounding * rounding));
        c.joint.sensor.position_noise = std::max(c.joint.sensor.position_noise, own);
    }
}

/// Noise of the efforts, and what is not known of them.
void find_effort_noise(Case& c, const Record& record, std::vector<Note>& notes)
{
    // what the unlogged commands of a slow log were is known up to the noise that the loop feeds through
    const bool unknown_between = c.ticks.unseen_between() && is_set(c.joint.control.period);
    const double command_noise =
        unknown_between ? noise_of_command(c.joint.control, c.sigma) * std::abs(c.joint.actuator.effort_gain) : 0;
    if (c.ticks.source == CommandSource::measured) c.drive_sigma = drive_noise(c, record, notes);
    if (c.ticks.has_effort) {
        const double range = rms(record.effort_measured);
        double sigma = c.joint.sensor.effort_noise;
        if (sigma == 0) {
            sigma = effort_noise_of(c, record.effort_measured);
            c.joint.sensor.effort_noise = sigma;
            sigma *= policy::doubted_estimate;
            notes.push_back({Note::Code::no_documented_effort_noise, record.name});
        }
        c.effort_sigma = std::hypot(sigma, policy::model_noise_of_effort * range,
                                    c.joint.actuator.kind == ActuatorKind::effort ? command_noise : 0);
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
    find_reading_noise(c, record, notes);
    find_effort_noise(c, record, notes);
    if (!record.at_rest_at_start) find_start(c, notes);
    find_integral(c);
    measure_load_error(c);
    return c;
}

}  // namespace

Joint joint_in(const Record& record, const Joint& nominal)
{
    Joint joint = nominal;
    for (const auto& [path, value] : record.overrides) {
        if (!find_parameter(joint, path)) throw CannotAnswer(CannotAnswer::Why::no_parameter, record.name, path);
        number_at(joint, path) = value;
    }
    return joint;
}

Case prepare(const Record& stamped, const Joint& nominal, std::vector<Note>& notes)
{
    const Joint joint = joint_in(stamped, nominal);
    Record record = stamped;
    if (auto even = is_set(joint.control.period) ? even_times(stamped.time, stamped.position, joint.control.period)
                                                 : std::nullopt) {
        record.time = std::move(*even);
        notes.push_back({Note::Code::scattered_stamps, record.name});
    }
    return prepare_with_effort(with_effort_of_current(std::move(record), joint), joint, notes);
}

void find_integrals(std::vector<Case>& cases)
{
    for (auto& c : cases) find_integral(c);
}

}  // namespace stickslip::gap
