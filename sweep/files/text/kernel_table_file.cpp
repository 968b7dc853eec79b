#include "sweep/files/text/kernel_table_file.h"

#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/series_file.h"

namespace stickslip {

KernelTable read_kernel_table(const std::filesystem::path& file, Units units)
{
    auto series = read_series(file, "g", SeriesQuantity{Quantity::stiffness, units});
    KernelTable table{std::move(series.time), std::move(series.value)};
    if (const std::string problem = table.problem(); !problem.empty()) throw BadInput(file.string() + ": " + problem);
    return table;
}

}  // namespace stickslip
