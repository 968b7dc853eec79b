#include "sweep/files/text/series_file.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/csv_cells.h"
#include "sweep/files/text/header_row.h"
#include "sweep/files/text/line_stream.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/text/units.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace stickslip {
namespace {

using files::trimmed;

constexpr std::size_t max_rows = 1'000'000;
constexpr std::size_t longest_shown = 60;  ///< characters of a row that does not fit

std::vector<std::string_view> cells(std::string_view line)
{
    std::vector<std::string_view> all;
    for (;;) {
        const auto end = line.find_first_of(",;\t");
        all.push_back(trimmed(line.substr(0, end)));
        if (end == line.npos) return all;
        line.remove_prefix(end + 1);
    }
}

std::string_view unquoted(std::string_view cell)
{
    return cell.size() > 1 && cell.front() == '"' && cell.back() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}

struct Column {
    std::size_t index;
    Unit unit{};
};

struct Columns {
    Column time{0}, value{1};
    std::size_t count = 2;
};

Unit unit_of_column(std::string_view cell, const std::optional<SeriesQuantity>& quantity, const std::string& place)
{
    const auto text = files::name_and_unit(unquoted(cell)).second;
    if (text.empty() || !quantity) return {};
    const auto reading = unit_for(text, quantity->quantity, quantity->units);
    if (!reading.error.empty()) throw BadInput(place + ": column " + std::string(cell) + ": " + reading.error);
    return reading.unit;
}

/// Where a header's columns are and in which units; two columns need no names.
Columns named(const std::vector<std::string_view>& header, std::string_view column,
              const std::optional<SeriesQuantity>& quantity, const std::string& place)
{
    const auto find = [&](std::string_view wanted) {
        for (std::size_t i = 0; i < header.size(); ++i)
            if (files::name_and_unit(unquoted(header[i])).first == wanted) return i;
        return header.size();
    };
    Columns columns;
    columns.count = header.size();
    const std::size_t time = find("time"), value = find(column);
    const bool nameless = header.size() == 2 && time != 1 && value != 0;
    if (!nameless) {
        for (const auto& [found, name] : {std::pair(time, std::string_view("time")), std::pair(value, column)})
            if (found == header.size())
                throw BadInput(place + ": has no column \"" + std::string(name) + "\"; needs time and " +
                               std::string(column) + ", or two columns only, time first");
        columns.time.index = time, columns.value.index = value;
    }
    columns.time.unit =
        unit_of_column(header[columns.time.index], SeriesQuantity{Quantity::time, Units(Motion::prismatic)}, place);
    columns.value.unit = unit_of_column(header[columns.value.index], quantity, place);
    return columns;
}

TimeSeries series_from(files::LineStream& lines, const std::filesystem::path& file, std::string_view column,
                       std::optional<SeriesQuantity> quantity)
{
    TimeSeries series;
    Columns columns;
    std::string_view line;
    bool first = true;
    while (lines.next(line)) {
        const std::string_view text = trimmed(line);
        if (text.empty() || text.starts_with('#')) continue;
        const auto place = file.string() + ":" + std::to_string(lines.line_number()) + ":1";
        const auto row = cells(text);
        double time = 0, value = 0;
        const auto number = [&](const Column& c, double& into) {
            if (c.index >= row.size() || !files::parse_cell(row[c.index], into) || std::isnan(into)) return false;
            into = c.unit.to_si(into);
            return true;
        };
        const bool numbers = number(columns.time, time) && number(columns.value, value);
        if (first && (!numbers || row.size() > 2)) {
            columns = named(row, column, quantity, place);
        } else {
            if (!numbers)
                throw BadInput(place + ": is not a row of two numbers, time and " + std::string(column) + ": \"" +
                               std::string(text.substr(0, longest_shown)) + "\"");
            if (row.size() != columns.count)
                throw BadInput(place + ": has " + std::to_string(row.size()) + " cells, the rows above have " +
                               std::to_string(columns.count) + "; numbers need a decimal point, not a comma");
            if (!series.time.empty() && !(time > series.time.back()))
                throw BadInput(place + ": time does not rise from row to row: " + files::number_text(time) +
                               " s after " + files::number_text(series.time.back()) + " s");
            if (series.time.size() == max_rows) throw BadInput(file.string() + ": has more than 1000000 rows");
            series.time.push_back(time);
            series.value.push_back(value);
        }
        first = false;
    }
    if (series.time.size() < 2)
        throw BadInput(file.string() + ": has fewer than two rows of numbers, time and " + std::string(column));
    return series;
}

}  // namespace

TimeSeries read_series(const std::filesystem::path& file, std::string_view column,
                       std::optional<SeriesQuantity> quantity)
{
    files::LineStream lines(file);
    try {
        return series_from(lines, file, column, quantity);
    } catch (const BadInput&) {
        lines.verify_archive();
        throw;
    }
}

}  // namespace stickslip
