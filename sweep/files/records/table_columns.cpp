#include "sweep/files/records/table_columns.h"

#include "sweep/files/text/header_row.h"

namespace stickslip {

std::vector<std::string> table_columns(const std::string& file)
{
    files::LineStream lines(file);
    std::string_view line;
    if (!files::next_header(lines, line)) return {};
    return files::header_names(line, files::separator_of(line));
}

}  // namespace stickslip
