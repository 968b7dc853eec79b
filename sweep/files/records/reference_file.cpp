#include "sweep/files/records/reference_file.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/csv_cells.h"
#include "sweep/files/text/line_stream.h"
#include "sweep/files/text/series_file.h"
#include "sweep/files/text/whole_file.h"

#include <fmt/format.h>

#include <iterator>
#include <string>

namespace stickslip {
namespace {

/// Whether the header names this column.
bool has_column(const std::filesystem::path& file, std::string_view name)
{
    files::LineStream lines(file);
    std::string_view line;
    while (lines.next(line)) {
        line = files::trimmed(line);
        if (line.empty() || line.starts_with('#')) continue;
        for (std::size_t from = 0; from != line.npos;) {
            const auto end = line.find_first_of(",;\t", from);
            auto cell = files::trimmed(line.substr(from, end == line.npos ? end : end - from));
            if (!cell.empty() && cell.front() == '"') cell.remove_prefix(1);
            cell = files::trimmed(cell.substr(0, cell.find_first_of("[\"")));
            if (cell == name) return true;
            from = end == line.npos ? end : end + 1;
        }
        break;
    }
    return false;
}

}  // namespace

ReferenceMotion read_reference(const std::filesystem::path& file, Units units)
{
    const auto position = read_series(file, "reference_position", SeriesQuantity{Quantity::position, units});
    ReferenceMotion reference{position.time, position.value, {}, {}};
    if (has_column(file, "reference_velocity"))
        reference.velocity = read_series(file, "reference_velocity", SeriesQuantity{Quantity::velocity, units}).value;
    if (has_column(file, "feed_forward"))
        reference.feed_forward = read_series(file, "feed_forward", SeriesQuantity{Quantity::command, units}).value;
    return reference;
}

std::filesystem::path write_record(const LoopRecord& r, const std::filesystem::path& directory)
{
    const auto file = directory / "record.csv";
    const bool fed = !r.feed_forward.empty();
    fmt::memory_buffer text;
    const auto add = [&](auto format, const auto&... values) {
        fmt::format_to(std::back_inserter(text), format, values...);
    };
    add(FMT_STRING("time,reference_position,reference_velocity,position,velocity,effort_command,effort_measured{}\n"),
        fed ? ",feed_forward" : "");
    for (std::size_t i = 0; i < r.time.size(); ++i) {
        add(FMT_STRING("{},{},{},{},{},{},{}"), r.time[i], r.reference_position[i], r.reference_velocity[i],
            r.position[i], r.velocity[i], r.effort_command[i], r.effort_measured[i]);
        if (fed) add(FMT_STRING(",{}"), r.feed_forward[i]);
        add(FMT_STRING("\n"));
    }
    write_whole(file, {text.data(), text.size()});
    return file;
}

}  // namespace stickslip
