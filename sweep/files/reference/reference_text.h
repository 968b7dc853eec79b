// The reference of every key and column as Markdown, from their declarations: `stickslip list keys --markdown`.
#pragma once
#include <string>

namespace stickslip {

/// Sections for joint files, specs, [record] tables, the columns of records and of results.nc.
std::string reference_text();

}  // namespace stickslip
