// A page whose tables lead to other pages and are shaded by shares.
#pragma once
#include "analysis/results/table_marks.h"
#include "render/render.h"

namespace stickslip {

/// As page(), with the marks of the tables of these titles and a link to the page above it. Throws
/// std::invalid_argument for marks of another length than their table.
std::string marked_page(const Report& report, const std::vector<RenderedFigure>& figures, const TableMarks& marks,
                        const PageAbove& above = {});

}  // namespace stickslip
