#include "sweep/files/text/csv_cells.h"

#include "analysis/base/field.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace stickslip::files {

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

bool parse_cell(std::string_view cell, double& value)
{
    cell = trimmed(cell);
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    if (cell.starts_with('+')) cell.remove_prefix(1);
    const auto [end, status] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (status == std::errc{} && end == cell.data() + cell.size() && std::isfinite(value)) return true;
    value = not_set;
    return cell.empty() || cell == "nan" || cell == "NaN" || cell == "NAN" || cell == "NA";
}

bool has_decimal_comma(std::string_view cell)
{
    std::string points(cell);
    std::replace(points.begin(), points.end(), ',', '.');
    double value = 0;
    return points != cell && parse_cell(points, value);
}

}  // namespace stickslip::files
