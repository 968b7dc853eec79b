#include "sweep/files/records/table_columns.h"

#include "sweep/files/records/record_header.h"
#include "sweep/files/text/csv.h"
#include "sweep/files/text/line_stream.h"

namespace stickslip {

std::vector<std::string> table_columns(const std::string& file)
{
    files::LineStream lines(file);
    std::string_view line;
    while (lines.next(line)) {
        line = files::trimmed(line);
        if (!line.empty() && !line.starts_with('#')) return files::header_names(line, files::separator_of(line));
    }
    return {};
}

}  // namespace stickslip
