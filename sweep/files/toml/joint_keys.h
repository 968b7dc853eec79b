// Why a key of a joint is unknown: it belongs to another model, kind or law, or it is misspelt. Internal to
// sweep/files.
#pragma once
#include "analysis/joint/joint.h"

#include <string>
#include <vector>

namespace stickslip::files {

/// Half a sentence for a message. `siblings` are the keys known in the same table of this joint.
std::string explain_unknown_key(const Joint& joint, const std::string& path, const std::vector<std::string>& siblings);

/// Every numeric path of this joint, for lists and nearest names.
std::vector<std::string> numeric_paths(const Joint& joint);

}  // namespace stickslip::files
