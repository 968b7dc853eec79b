#include "sweep/files/text/header_row.h"

#include "sweep/files/text/csv_cells.h"
#include "sweep/files/text/units.h"

#include <algorithm>

namespace stickslip::files {

bool next_header(LineStream& lines, std::string_view& line)
{
    do {
        if (!lines.next(line)) return false;
    } while (trimmed(line).empty() || trimmed(line).starts_with('#'));
    return true;
}

char separator_of(std::string_view line)
{
    if (line.find(',') != std::string_view::npos) return ',';
    return line.find(';') != std::string_view::npos ? ';' : '\t';
}

std::vector<std::string> header_names(std::string_view line, char separator)
{
    std::vector<std::string> names;
    while (true) {
        std::string_view cell = trimmed(line);
        std::size_t length = 0;
        if (cell.starts_with('"') && cell.find('"', 1) != std::string_view::npos) {
            line = cell;
            length = line.find('"', 1) + 1;
            cell = line.substr(1, length - 2);
            length = std::min(line.size(), line.find(separator, length));
        } else {
            length = std::min(line.size(), line.find(separator));
            cell = line.substr(0, length);
        }
        names.emplace_back(trimmed(cell));
        if (length == line.size()) return names;
        line.remove_prefix(length + 1);
    }
}

std::pair<std::string, std::string> name_and_unit(std::string_view column)
{
    const auto parts_at = [&](std::size_t from) {
        return std::pair(std::string(trimmed(column.substr(0, from))),
                         std::string(trimmed(column.substr(from + 1, column.size() - from - 2))));
    };
    const auto square = column.find('['), round = column.find('(');
    if (square != std::string_view::npos && column.ends_with(']')) return parts_at(square);
    if (round != std::string_view::npos && column.ends_with(')'))
        if (auto parts = parts_at(round); parse_unit(parts.second).error.empty()) return parts;
    return {std::string(column), ""};
}

}  // namespace stickslip::files
