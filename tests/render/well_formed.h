// A reader of tags that knows nothing of how the text was made: the oracle for "well-formed".
#pragma once
#include <string>

namespace stickslip::oracle {

/// Empty when every tag closes in order, attributes are quoted and & only begins an entity; otherwise the first fault.
/// HTML's void elements need no end, the content of script and style is not looked at.
std::string fault_in_markup(const std::string& text);

}  // namespace stickslip::oracle
