// Many diagnoses of one joint in plain words.
#pragma once
#include "sweep/study/compare/timeline.h"

#include <string>

namespace stickslip {

/// "8 runs from 2026-01-05 to 2026-05-25. On 2026-04-01 the gap is new: …"
std::string timeline_sentence(const Timeline& timeline);

}  // namespace stickslip
