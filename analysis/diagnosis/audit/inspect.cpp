#include "analysis/diagnosis/audit/inspect.h"

#include "analysis/diagnosis/audit/effort_drive.h"
#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/policy/policy.h"
#include "analysis/diagnosis/records/ticks.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

void check_column(const Record& r, const char* name, const std::vector<double>& column, Inspection& result)
{
    if (column.empty()) return;
    if (column.size() != r.rows()) {
        result.errors.push_back(r.name + ": column " + name + " has " + std::to_string(column.size()) +
                                " values, time has " + std::to_string(r.rows()));
        return;
    }
    for (std::size_t k = 0; k < column.size(); ++k)
        if (!std::isfinite(column[k])) {
            result.errors.push_back(r.name + ": column " + name + " is not a finite number in row " +
                                    std::to_string(k + 1));
            return;
        }
}

}  // namespace

Inspection inspect(const Record& r, const Joint& joint)
{
    Inspection result;
    if (r.time.empty()) {
        result.errors.push_back(r.name + ": there is no time column, or it is empty");
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
        if (!(r.inertia[k] > 0))
            result.errors.push_back(r.name + ": inertia is not positive in row " + std::to_string(k + 1));
    if (!result.errors.empty()) return result;
    for (std::size_t k = 1; k < r.rows(); ++k)
        if (r.time[k] <= r.time[k - 1]) {
            result.errors.push_back(r.name + ": time " + (r.time[k] == r.time[k - 1] ? "repeats" : "runs backwards") +
                                    " in row " + std::to_string(k + 1) + " (" + std::to_string(r.time[k]) + " s)");
            return result;
        }
    if (r.position.empty()) {
        result.errors.push_back(r.name + ": there is no position column");
        return result;
    }
    if (static_cast<double>(r.rows()) < policy::fewest_rows)
        result.shortages.push_back({.code = Note::Code::too_few_rows,
                                    .record = r.name,
                                    .values = {static_cast<double>(r.rows()), policy::fewest_rows}});
    const double resolution = std::max(joint.sensor.encoder_quantum, joint.sensor.position_noise);
    if (span_of(r.position) <= 8 * resolution || span_of(r.position) == 0)
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
