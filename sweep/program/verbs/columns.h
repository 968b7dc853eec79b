// A list of entries as columns on a terminal.
#pragma once
#include <nlohmann/json.hpp>

#include <string>

namespace stickslip {

/// A heading from the names of the first entry's fields, then each entry. Values are texts and flags. A text wider than
/// a column goes on below, at its spaces: one long cell does not push the columns beside it off the terminal.
std::string columns_text(nlohmann::ordered_json list);

}  // namespace stickslip
