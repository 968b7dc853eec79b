// What the answer of a diagnosis rests on, in words.
#pragma once
#include "analysis/results/diagnosis.h"

#include <string>

namespace stickslip {

/// A reason as people read it: its own text, or what its code and numbers mean.
std::string note_text(const Note& note);

}  // namespace stickslip
