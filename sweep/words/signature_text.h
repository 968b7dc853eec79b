// What gives a cause away in a record, and what its numbers are called.
#pragma once
#include <string>
#include <vector>

namespace stickslip {

/// The signatures of a cause, see Cause::signatures, one after the other.
std::string signature_text(const std::vector<std::string>& of);

/// What a number of a data sheet is called, see SheetValue::key.
std::string sheet_label(const std::string& key);

}  // namespace stickslip
