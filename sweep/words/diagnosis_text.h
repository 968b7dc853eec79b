// Why a diagnosis answers as it does, and what it remarks, in sentences. Nothing depends on their wording.
#pragma once
#include "analysis/results/note.h"

#include <string>

namespace stickslip {

/// One sentence from the note's code, names and numbers, after the record that it is about.
std::string note_text(const Note& note);

/// The same as a sentence of its own. Names, of causes, numbers or files, keep their first letter.
std::string note_sentence(const Note& note);

/// The same without the record: what several records may share.
std::string remark_text(const Note& note);

}  // namespace stickslip
