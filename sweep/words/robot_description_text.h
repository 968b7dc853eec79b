// Inertias that a robot's description has and no body can have, in plain words.
#pragma once
#include "sweep/study/import/robot.h"

#include <string>

namespace stickslip {

/// Sentence.
std::string impossible_inertia_text(const ImpossibleInertia& of);

}  // namespace stickslip
