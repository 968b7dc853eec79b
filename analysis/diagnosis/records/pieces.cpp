#include "analysis/diagnosis/records/pieces.h"

#include "analysis/diagnosis/policy/records.h"
#include "analysis/diagnosis/records/ticks.h"

#include <cstdio>

namespace stickslip::gap {

std::string name_of_part(const std::string& record, double begins)
{
    char text[48];
    std::snprintf(text, sizeof text, " from %.6g s", begins);
    return record + text;
}

namespace {

Record part(const Record& whole, std::size_t from, std::size_t to)
{
    Record r = whole;
    for (auto* column :
         {&r.time, &r.reference_position, &r.reference_velocity, &r.position, &r.velocity, &r.effort_command,
          &r.effort_measured, &r.drive, &r.current, &r.supply_voltage, &r.temperature, &r.torque_enable,
          &r.link_position, &r.feed_forward, &r.load_effort, &r.load_error, &r.inertia, &r.normal_load})
        if (!column->empty())
            *column = {column->begin() + static_cast<std::ptrdiff_t>(from),
                       column->begin() + static_cast<std::ptrdiff_t>(to)};
    r.name = name_of_part(whole.name, whole.time[from]);
    if (from > 0) r.at_rest_at_start.reset();
    r.began = whole.began.value_or(whole.time[0]);
    return r;
}

}  // namespace

std::vector<Record> pieces(const Record& record, std::vector<Note>& notes)
{
    const auto longest = policy::most_lost_rows * median_step(record.time);
    std::vector<std::size_t> starts{0};
    for (std::size_t k = 1; k < record.rows(); ++k)
        if (record.time[k] - record.time[k - 1] > longest) starts.push_back(k);
    if (starts.size() == 1) return {record};
    std::vector<Record> all;
    for (std::size_t i = 0; i < starts.size(); ++i)
        all.push_back(part(record, starts[i], i + 1 < starts.size() ? starts[i + 1] : record.rows()));
    const std::size_t hole = starts[1];
    notes.push_back({.code = Note::Code::holes,
                     .record = record.name,
                     .values = {static_cast<double>(starts.size() - 1), record.time[hole - 1], record.time[hole]}});
    return all;
}

}  // namespace stickslip::gap
