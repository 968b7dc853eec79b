// How numbers are set on a page: a number never parts from its unit, a minus is a minus, powers of ten are written as
// such.
#pragma once
#include <string>
#include <string_view>

namespace stickslip::drawing {

/// Mark-up in, mark-up out: "-36.7 kN/m" gets U+2212 and a no-break space, "5e-05 N·m" becomes "5×10^{−5} N·m". Words,
/// names with hyphens, ranges of dates and options of a command stay as they are.
std::string typeset(std::string_view markup);

}  // namespace stickslip::drawing
