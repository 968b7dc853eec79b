// A table of a page, with the marks of its cells. Internal to render/page.
#pragma once
#include "render/marked_page.h"

#include <string>

namespace stickslip {

std::string table(const Table& t, const CellMarks& marks);

}  // namespace stickslip
