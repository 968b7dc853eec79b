#include "sweep/files/series_file.h"

#include "sweep/files/bad_input.h"
#include "sweep/files/csv.h"
#include "sweep/files/line_stream.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace stickslip {
namespace {

using files::trimmed;

constexpr std::size_t max_rows = 1'000'000;

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

/// "normal_load" of "normal_load [N]".
std::string_view name_of(std::string_view cell)
{
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    return trimmed(cell.substr(0, cell.find('[')));
}

struct Columns {
    std::size_t time = 0, value = 1;
};

/// Where a header's columns are; two columns need no names.
Columns named(const std::vector<std::string_view>& header, std::string_view column, const std::string& place)
{
    if (header.size() == 2) return {};
    const auto find = [&](std::string_view wanted) {
        for (std::size_t i = 0; i < header.size(); ++i)
            if (name_of(header[i]) == wanted) return i;
        throw BadInput(place + ": has no column \"" + std::string(wanted) +
                       "\"; needs time and that one, or two columns only");
    };
    return {find("time"), find(column)};
}

}  // namespace

Series read_series(const std::filesystem::path& file, std::string_view column)
{
    files::LineStream lines(file);
    Series series;
    Columns columns;
    std::string_view line;
    bool first = true;
    while (lines.next(line)) {
        const std::string_view text = trimmed(line);
        if (text.empty() || text.starts_with('#')) continue;
        const auto place = file.string() + ":" + std::to_string(lines.line_number()) + ":1";
        const auto row = cells(text);
        double time = 0, value = 0;
        const auto number = [&](std::size_t i, double& into) {
            return i < row.size() && files::parse_cell(row[i], into) && !std::isnan(into);
        };
        const bool numbers = number(columns.time, time) && number(columns.value, value);
        if (first && (!numbers || row.size() > 2)) {
            columns = named(row, column, place);
        } else {
            if (!numbers) throw BadInput(place + ": is no row of two numbers, time and " + std::string(column));
            if (!series.time.empty() && !(time > series.time.back()))
                throw BadInput(place + ": time does not rise from row to row");
            if (series.time.size() == max_rows) throw BadInput(file.string() + ": has more than 1000000 rows");
            series.time.push_back(time);
            series.value.push_back(value);
        }
        first = false;
    }
    if (series.time.size() < 2) throw BadInput(file.string() + ": has fewer than two rows");
    return series;
}

std::vector<double> Series::sampled(double step, int count) const
{
    // the integral of the straight lines up to a time behind the first row
    std::size_t i = 0;
    double whole = 0;  // up to row i
    const auto integral = [&](double t) {
        while (i + 1 < time.size() && time[i + 1] - time[0] <= t) {
            whole += 0.5 * (value[i] + value[i + 1]) * (time[i + 1] - time[i]);
            ++i;
        }
        const double rest = t - (time[i] - time[0]);
        const bool last = i + 1 == time.size();
        const double slope = last ? 0 : (value[i + 1] - value[i]) / (time[i + 1] - time[i]);
        return whole + rest * (value[i] + 0.5 * slope * rest);
    };
    std::vector<double> means;
    double before = 0;
    for (int k = 1; k <= count; ++k) {
        const double now = integral(step * k);
        means.push_back((now - before) / step);
        before = now;
    }
    return means;
}

}  // namespace stickslip
