#include "analysis/diagnosis/records/lost_rows.h"

#include "analysis/diagnosis/policy/records.h"
#include "analysis/diagnosis/records/between_rows.h"
#include "analysis/diagnosis/records/ticks.h"

#include <cmath>

namespace stickslip::gap {

std::vector<std::size_t> strides(const std::vector<double>& time, double step)
{
    std::vector<std::size_t> of;
    for (std::size_t k = 1; k < time.size(); ++k) {
        const double rows = (time[k] - time[k - 1]) / step;
        if (rows > policy::most_lost_rows || std::abs(rows - std::round(rows)) > whole_ticks || std::round(rows) < 1)
            return {};
        of.push_back(static_cast<std::size_t>(std::round(rows)));
    }
    return of;
}

Record with_lost_rows(const Record& r, const std::vector<std::size_t>& strides, std::vector<std::uint8_t>& logged)
{
    Record full = r;
    const auto fill = [&](std::vector<double>& column, auto&& value) {
        if (column.empty()) return;
        const std::vector<double> was = std::move(column);
        column.clear();
        for (std::size_t k = 0; k < was.size(); ++k) {
            column.push_back(was[k]);
            for (std::size_t i = 1; k < strides.size() && i < strides[k]; ++i)
                column.push_back(value(was, k, static_cast<double>(i) / static_cast<double>(strides[k])));
        }
    };
    const auto straight = [](const std::vector<double>& x, std::size_t k, double s) {
        return x[k] + s * (x[k + 1] - x[k]);
    };
    const auto unknown = [](const std::vector<double>&, std::size_t, double) { return not_set; };
    const auto as_before = [](const std::vector<double>& x, std::size_t k, double) { return x[k]; };
    fill(full.time, straight);
    fill(full.position, between);
    fill(full.reference_position, reference_between);
    for (auto* column : {&full.reference_velocity, &full.link_position, &full.feed_forward, &full.load_effort,
                         &full.load_error, &full.inertia})
        fill(*column, straight);
    for (auto* column : {&full.velocity, &full.effort_command, &full.drive, &full.effort_measured, &full.current})
        fill(*column, unknown);
    for (auto* column : {&full.supply_voltage, &full.temperature, &full.torque_enable, &full.normal_load})
        fill(*column, as_before);
    for (std::size_t k = 0; k < r.rows(); ++k) {
        logged.push_back(1);
        if (k < strides.size()) logged.insert(logged.end(), strides[k] - 1, 0);
    }
    return full;
}

}  // namespace stickslip::gap
