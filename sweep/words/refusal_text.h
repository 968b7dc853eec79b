// What a question was refused for.
#pragma once
#include "analysis/results/cannot_answer.h"

#include <stdexcept>
#include <string>

namespace stickslip {

/// One sentence after the record, table or row that it is about.
std::string cannot_answer_text(const CannotAnswer& refused);

/// The words for the refusal's code, or where it has none what the thrower wrote.
std::string refusal_text(const std::invalid_argument& refused);

}  // namespace stickslip
