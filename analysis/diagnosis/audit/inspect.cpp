#include "analysis/diagnosis/audit/inspect.h"

#include "analysis/diagnosis/audit/effort_drive.h"
#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/policy/records.h"
#include "analysis/diagnosis/records/ticks.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

using Why = CannotAnswer::Why;

double number(std::size_t count)
{
    return static_cast<double>(count);
}

void refuse(Why why, const Record& r, Inspection& result, const char* column = "", std::vector<double> values = {})
{
    result.errors.emplace_back(why, r.name, column, std::move(values));
}

void check_column(const Record& r, const char* name, const std::vector<double>& column, Inspection& result)
{
    if (column.empty()) return;
    if (column.size() != r.rows()) {
        refuse(Why::column_length, r, result, name, {number(column.size()), number(r.rows())});
        return;
    }
    for (std::size_t k = 0; k < column.size(); ++k)
        if (!std::isfinite(column[k])) {
            refuse(Why::not_finite, r, result, name, {number(k + 1)});
            return;
        }
}

}  // namespace

Inspection inspect(const Record& r, const Joint& joint)
{
    Inspection result;
    if (r.time.empty()) {
        refuse(Why::no_time, r, result);
        return result;
    }
    check_column(r, "time", r.time, result);
    check_column(r, "position", r.position, result);
    check_column(r, "reference_position", r.reference_position, result);
    check_column(r, "reference_velocity", r.reference_velocity, result);
    check_column(r, "velocity", r.velocity, result);
    check_column(r, "effort_command", r.effort_command, result);
    check_column(r, "effort_measured", r.effort_measured, result);
    check_column(r, "drive", r.drive, result);
    check_column(r, "current", r.current, result);
    check_column(r, "supply_voltage", r.supply_voltage, result);
    check_column(r, "feed_forward", r.feed_forward, result);
    check_column(r, "load_effort", r.load_effort, result);
    check_column(r, "load_error", r.load_error, result);
    check_column(r, "inertia", r.inertia, result);
    for (std::size_t k = 0; k < r.inertia.size() && result.errors.empty(); ++k)
        if (!(r.inertia[k] > 0)) refuse(Why::inertia_not_positive, r, result, "", {number(k + 1)});
    if (!result.errors.empty()) return result;
    for (std::size_t k = 1; k < r.rows(); ++k)
        if (r.time[k] <= r.time[k - 1]) {
            refuse(r.time[k] == r.time[k - 1] ? Why::time_repeats : Why::time_runs_back, r, result, "",
                   {number(k + 1), r.time[k]});
            return result;
        }
    if (r.position.empty()) {
        refuse(Why::no_position, r, result);
        return result;
    }
    if (number(r.rows()) < policy::fewest_rows)
        result.shortages.push_back(
            {.code = Note::Code::too_few_rows, .record = r.name, .values = {number(r.rows()), policy::fewest_rows}});
    const double resolution = std::max(joint.sensor.encoder_quantum, joint.sensor.position_noise);
    if (span_of(r.position) <= policy::still * resolution || span_of(r.position) == 0)
        result.shortages.push_back({Note::Code::position_still, r.name});
    const double ticks = r.rows() > 1 && is_set(joint.control.period) ? median_step(r.time) / joint.control.period : 1;
    if (ticks > slower_log && (ticks >= most_ticks_per_row || std::abs(ticks - std::round(ticks)) > whole_ticks))
        result.notes.push_back({.code = Note::Code::uneven_ticks, .record = r.name, .values = {ticks}});
    const bool command = !r.effort_command.empty() || !r.drive.empty();
    const bool effort = !with_effort_of_current(r, joint).effort_measured.empty();
    if (!command && !effort && r.reference_position.empty())
        result.shortages.push_back({Note::Code::nothing_drives, r.name});
    if (!command && !r.reference_position.empty()) result.notes.push_back({Note::Code::no_command, r.name});
    if (r.effort_measured.empty() && r.current.empty()) result.notes.push_back({Note::Code::no_effort, r.name});
    return result;
}

}  // namespace stickslip::gap
