// The header row of a table: where it stands, and the names and units in it. Internal to sweep/files.
#pragma once
#include "sweep/files/text/line_stream.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stickslip::files {

/// The first line that is neither empty nor a `#` comment, without a byte order mark; false where there is none.
bool next_header(LineStream& lines, std::string_view& line);

/// Comma; semicolon or tab where the line has no comma.
char separator_of(std::string_view line);

/// The names of a header row, without their quotation marks.
std::vector<std::string> header_names(std::string_view line, char separator);

/// "position [deg]", "position (deg)": the name and the unit, which is empty where none stands there. Round brackets
/// hold a unit only where it is one: "position (link)" is a name.
std::pair<std::string, std::string> name_and_unit(std::string_view column);

}  // namespace stickslip::files
