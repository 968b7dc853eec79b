// The date on a page. There is none unless requested, so that equal results give equal pages.
#pragma once
#include <string>

namespace stickslip {

/// "2026-11-21T09:00:00Z" of `wanted`: "now", seconds since 1970, or empty for the variable SOURCE_DATE_EPOCH; empty
/// where neither is given. Throws BadInput for anything else.
std::string timestamp(const std::string& wanted);

}  // namespace stickslip
