#include "sweep/files/kernel_table_file.h"

#include "sweep/files/bad_input.h"
#include "sweep/files/csv.h"
#include "sweep/files/line_stream.h"

#include <cmath>

namespace stickslip {
namespace {

constexpr std::size_t max_rows = 1'000'000;  // every evaluation of the law walks the table

}  // namespace

KernelTable read_kernel_table(const std::filesystem::path& file)
{
    files::LineStream lines(file);
    KernelTable table;
    std::string_view line;
    bool header_allowed = true;
    while (lines.next(line)) {
        const std::string_view text = files::trimmed(line);
        if (text.empty() || text.starts_with('#')) continue;
        const auto comma = text.find_first_of(",;\t");
        double time = 0, value = 0;
        const bool numbers = comma != std::string_view::npos && files::parse_cell(text.substr(0, comma), time) &&
                             files::parse_cell(text.substr(comma + 1), value) && !std::isnan(time + value);
        if (!numbers && !header_allowed)
            throw BadInput(file.string() + ":" + std::to_string(lines.line_number()) +
                           ":1: is no row of two numbers, time and g");
        header_allowed = false;
        if (!numbers) continue;
        if (table.time.size() == max_rows) throw BadInput(file.string() + ": has more than 1000000 rows");
        table.time.push_back(time);
        table.value.push_back(value);
    }
    if (const std::string problem = table.problem(); !problem.empty()) throw BadInput(file.string() + ": " + problem);
    return table;
}

}  // namespace stickslip
