// A joint to begin with: any model and law, with numbers that slide and can stick, to be replaced by one's own.
#pragma once
#include "analysis/joint/joint.h"

#include <string>

namespace stickslip {

/// Complete: nothing that is required is missing. `law` is one of `list laws` and stands on every body.
/// Throws std::invalid_argument for a law that does not exist.
Joint starting_joint(Model model, const std::string& law, Motion motion);

}  // namespace stickslip
