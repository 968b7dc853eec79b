#include "analysis/diagnosis/records/near_clock.h"

#include "analysis/base/field.h"
#include "analysis/diagnosis/records/ticks.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {
namespace {

/// Evenly spaced stamps in place of those that differ from them by their rounding alone, lost rows included.
void even_out(std::vector<double>& time, double resolution)
{
    const double step = median_step(time);
    if (!(step > resolution)) return;
    std::vector<double> rows{0};
    for (std::size_t k = 1; k < time.size(); ++k)
        rows.push_back(rows.back() + std::round((time[k] - time[k - 1]) / step));
    if (!(rows.back() > 0)) return;
    const double start = time[0], row = (time.back() - start) / rows.back();
    const auto even = [&](std::size_t k) { return start + row * rows[k]; };
    for (std::size_t k = 0; k < time.size(); ++k)
        if (!(std::abs(time[k] - even(k)) <= 2 * resolution)) return;
    for (std::size_t k = 0; k < time.size(); ++k) time[k] = even(k);
}

bool has_far_clock(const Record& record)
{
    constexpr double far = 1e6;  // numerical: s, beyond which digits of a microsecond's clock are missing
    return !record.time.empty() && std::abs(record.time[0]) > far;
}

}  // namespace

bool any_far_clock(const std::vector<Record>& records)
{
    return std::ranges::any_of(records, has_far_clock);
}

std::vector<Record> on_near_clocks(std::vector<Record> records)
{
    double first = infinity;
    for (const auto& r : records)
        if (has_far_clock(r)) first = std::min(first, r.time[0]);
    for (auto& r : records) {
        if (!has_far_clock(r)) continue;
        const double last = std::abs(r.time.back());
        for (double& t : r.time) t -= first;
        if (r.began) *r.began -= first;
        even_out(r.time, std::nextafter(last, infinity) - last);
    }
    return records;
}

}  // namespace stickslip::gap
