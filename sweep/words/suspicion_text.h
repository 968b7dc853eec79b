// What a record holds that no record of its joint can, in sentences.
#pragma once
#include "analysis/results/note.h"

#include <string>

namespace stickslip {

/// What is suspected, why, and what a user can do, without the name of the record. Throws std::logic_error for a note
/// of another kind.
std::string suspicion_text(const Note& note);

/// Whether suspicion_text has words for it.
bool is_suspicion(Note::Code code);

}  // namespace stickslip
