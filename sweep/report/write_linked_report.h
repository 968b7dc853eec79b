// A report whose tables lead to other pages, or that is itself a part of another page, as files.
#pragma once
#include "analysis/results/report.h"
#include "analysis/results/table_marks.h"

#include <filesystem>

namespace stickslip {

/// As write_report, with the marks of tables and the page above.
std::filesystem::path write_linked_report(const Report& report, const std::filesystem::path& directory,
                                          const TableMarks& marks, const PageAbove& above = {});

}  // namespace stickslip
