#include "analysis/diagnosis/records/ticks.h"

#include "analysis/diagnosis/records/between_rows.h"
#include "analysis/diagnosis/records/lost_rows.h"
#include "analysis/diagnosis/records/start_velocity.h"
#include "analysis/numerics/reference_rate.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

bool equal_steps(const std::vector<double>& time, double step)
{
    for (std::size_t k = 1; k < time.size(); ++k)
        if (std::abs(time[k] - time[k - 1] - step) > whole_ticks * step) return false;
    return true;
}

void fill_reference_rate(const Record& r, Ticks& t)
{
    if (r.reference_velocity.empty()) {
        t.reference_rate = reference_rates(t.time, t.reference, t.jumps, static_cast<std::size_t>(t.ticks_per_row));
        return;
    }
    for (std::size_t k = 0; k < t.size(); ++k) {
        const std::size_t row = k / t.ticks_per_row, rest = k % t.ticks_per_row;
        const double s = static_cast<double>(rest) / t.ticks_per_row;
        t.reference_rate[k] = rest == 0 ? r.reference_velocity[row]
                              : r.reference_position.empty()
                                  ? between(r.reference_velocity, row, s)
                                  : rate_between(r.reference_position, r.reference_velocity, row, s);
    }
}

}  // namespace

double median_step(const std::vector<double>& time)
{
    std::vector<double> steps;
    for (std::size_t k = 1; k < time.size(); ++k) steps.push_back(time[k] - time[k - 1]);
    if (steps.empty()) return 1;
    std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
    return steps[steps.size() / 2];
}

double between_rows(const Ticks& t, std::size_t k, double period, double tau)
{
    const double g = period / (tau + period), sum = (t.position[k] - t.position[k - 2]) / period;
    const double drive = t.velocity[k] - (1 - g) * (1 - g) * t.velocity[k - 2];
    const double last = (drive / g - (1 - g) * sum) / g;
    return t.position[k] - period * last;
}

void rebuild_halves(Ticks& t, const Joint& joint)
{
    const double quantum = joint.sensor.encoder_quantum;
    for (std::size_t k = 2; k < t.size(); k += 2) {
        const double middle = between_rows(t, k, joint.control.period, joint.control.velocity_estimate.tau);
        t.position[k - 1] = quantum > 0 ? quantum * std::round(middle / quantum) : middle;
    }
    t.rebuilt = true;
}

void interpolate_halves(Ticks& t)
{
    std::vector<double> rows;
    for (std::size_t k = 0; k < t.size(); k += 2) rows.push_back(t.position[k]);
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) t.position[2 * k + 1] = between(rows, k, 0.5);
    t.rebuilt = false;
}

namespace {

/// A known signal at every tick, straight between the rows.
std::vector<double> at_every_tick(const std::vector<double>& rows, int per_row, std::size_t ticks)
{
    std::vector<double> all;
    if (rows.empty()) return all;
    const auto m = static_cast<std::size_t>(per_row);
    for (std::size_t k = 0; k < ticks; ++k) {
        const std::size_t row = k / m, next = std::min(row + 1, rows.size() - 1);
        all.push_back(std::lerp(rows[row], rows[next], static_cast<double>(k % m) / static_cast<double>(m)));
    }
    return all;
}

/// How many ticks of the loop a row stands for: 1 where its period does not divide the step of the log.
int ticks_per_row(double step, double period)
{
    const double fold = step / period;
    return fold > slower_log && std::abs(fold - std::round(fold)) < whole_ticks && fold < most_ticks_per_row
               ? static_cast<int>(std::round(fold))
               : 1;
}

void reserve_ticks(Ticks& t, std::size_t n, double step, double supply)
{
    t.time.resize(n);
    t.step.assign(n, step / t.ticks_per_row);
    t.reference.assign(n, not_set);
    t.reference_rate.assign(n, not_set);
    t.position.resize(n);
    t.velocity.assign(n, not_set);
    t.command.assign(n, not_set);
    t.effort.assign(n, not_set);
    t.supply.assign(n, supply);
    t.enabled.assign(n, 1);
    t.logged.assign(n, 0);
}

/// Rows at their ticks, and between them what is known of motion, reference and supply. `logged` has an entry a row.
/// Between 0 and 1, which a log writes for off and on.
constexpr double on = 0.5;  // numerical: between the two values of a switch

void fill_from_rows(const Record& r, const std::vector<double>& commanded, const std::vector<std::uint8_t>& logged,
                    Ticks& t)
{
    const int m = t.ticks_per_row;
    std::vector<std::size_t> jump_rows;
    if (t.has_reference) jump_rows = jumps_of(r.reference_position);
    const auto near_jump = [&](std::size_t row) {
        return std::any_of(jump_rows.begin(), jump_rows.end(),
                           [&](std::size_t j) { return j + 1 >= row && row + 1 >= j; });
    };
    for (std::size_t row : jump_rows) t.jumps.push_back(row * static_cast<std::size_t>(m));
    for (std::size_t k = 0; k < t.size(); ++k) {
        const std::size_t row = k / m, rest = k % m;
        if (rest == 0) {
            t.logged[k] = t.lost ? logged[row] : 1;
            t.time[k] = r.time[row];
            t.position[k] = r.position[row];
            t.reference[k] = at_or(r.reference_position, row, not_set);
            t.velocity[k] = at_or(r.velocity, row, not_set);
            t.command[k] = at_or(commanded, row, not_set);
            t.effort[k] = at_or(r.effort_measured, row, not_set);
        } else {
            const double s = static_cast<double>(rest) / m;
            t.time[k] = r.time[row] + s * (r.time[row + 1] - r.time[row]);
            t.position[k] = between(r.position, row, s);
            if (t.has_reference) t.reference[k] = reference_between(r.reference_position, row, s);
            // next to a jump a polynomial would ring
            if (t.has_reference && near_jump(row)) t.reference[k] = r.reference_position[row];
        }
        if (!r.supply_voltage.empty()) t.supply[k] = r.supply_voltage[row];
        if (!r.torque_enable.empty()) t.enabled[k] = r.torque_enable[row] > on;
    }
    for (std::size_t k = 0; k + 1 < t.size(); ++k) t.step[k] = t.time[k + 1] - t.time[k];
}

CommandSource source_of(const Record& r)
{
    if (!r.effort_command.empty() || !r.drive.empty()) return CommandSource::logged;
    if (!r.reference_position.empty()) return CommandSource::reconstructed;
    return r.effort_measured.empty() ? CommandSource::none : CommandSource::measured;
}

/// The mean effort of every tick: held where the log has a row for every tick of the loop, else straight between rows.
void drive_by_measured(const std::vector<double>& effort, bool held, Ticks& t)
{
    const auto m = static_cast<std::size_t>(t.ticks_per_row);
    double last = 0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        const std::size_t row = k / m, next = held ? row : std::min(row + 1, effort.size() - 1);
        const double part = (static_cast<double>(k % m) + 0.5) / static_cast<double>(m);
        const double mean = std::lerp(effort[row], effort[next], part);
        t.command[k] = last = is_set(mean) ? mean : last;
        t.effort[k] = not_set;
    }
}

}  // namespace

Ticks on_clock(const Record& record, const Joint& joint)
{
    Ticks t;
    t.name = record.name;
    const double step = median_step(record.time);
    t.regular = equal_steps(record.time, step);
    const auto stride = t.regular ? std::vector<std::size_t>() : strides(record.time, step);
    t.lost = !stride.empty();
    std::vector<std::uint8_t> logged_rows;
    const Record filled = t.lost ? with_lost_rows(record, stride, logged_rows) : Record{};
    const Record& r = t.lost ? filled : record;
    if (is_set(joint.control.period) && (t.regular || t.lost))
        t.ticks_per_row = ticks_per_row(step, joint.control.period);
    const int m = t.ticks_per_row;
    const std::size_t rows = r.rows(), n = rows == 0 ? 0 : (rows - 1) * m + 1;
    t.has_velocity = !r.velocity.empty();
    t.has_reference = !r.reference_position.empty();
    t.at_rest = r.at_rest_at_start.value_or(true);
    if (rows > 0) t.began = r.began.value_or(r.time[0]);
    t.source = source_of(r);
    t.has_effort = !r.effort_measured.empty() && t.source != CommandSource::measured;
    const std::vector<double>& commanded = r.effort_command.empty() ? r.drive : r.effort_command;
    reserve_ticks(t, n, step, joint.actuator.supply_voltage);
    t.feed_forward = at_every_tick(r.feed_forward, m, n);
    t.load = at_every_tick(r.load_effort, m, n);
    t.load_error = at_every_tick(r.load_error, m, n);
    t.inertia = at_every_tick(r.inertia, m, n);
    const Mechanism& body = joint.mechanism;
    const double documented = body.model == Model::single_mass ? body.inertia : body.link_inertia;
    for (double& inertia : t.inertia) inertia /= documented;
    fill_from_rows(r, commanded, logged_rows, t);
    if (t.source == CommandSource::measured) {
        const double period = joint.control.period;
        const bool every_tick = t.regular && std::abs(step - period) < whole_ticks * period;  // NaN: no loop is known
        drive_by_measured(r.effort_measured, every_tick, t);
    }
    if (m == 2 && !t.lost && t.has_velocity && joint.control.velocity_estimate.form != EstimateForm::exact &&
        joint.control.velocity_estimate.average == 1)
        rebuild_halves(t, joint);
    if (t.has_reference) fill_reference_rate(r, t);
    if (!t.at_rest) start_moving(t);
    return t;
}

void place_jump(Ticks& t, const Control& control, std::size_t which, int after)
{
    const std::size_t from = t.jumps[which], m = static_cast<std::size_t>(t.ticks_per_row), to = from + m;
    if (to >= t.size()) return;
    const bool by_rate = t.reference_rebuilt && control.reference_velocity && control.k_v != 0;
    const auto wanted = [&](std::size_t k) { return control.k_p * t.reference[k] + control.k_v * t.reference_rate[k]; };
    for (std::size_t i = 1; i < m; ++i) {
        const std::size_t k = from + i, as = i < static_cast<std::size_t>(after) ? from : to;
        if (by_rate)
            t.reference_rate[k] = (wanted(as) - control.k_p * t.reference[k]) / control.k_v;
        else
            t.reference[k] = t.reference[as];
    }
}

}  // namespace stickslip::gap
