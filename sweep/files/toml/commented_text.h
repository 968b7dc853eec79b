// A file to fill in: every key with its unit, range and meaning, those at their default as comments.
#pragma once
#include "analysis/joint/keys.h"

#include <string>
#include <vector>

namespace stickslip {

/// Keys in the order of their tables. What is set stands as it is; the rest is commented out with its default.
std::string commented_toml(const std::vector<Key>& keys, Units units);

/// joint.toml for this joint.
std::string commented_joint(const Joint& joint);

/// A sweep over both gains and the velocity of this joint, which stands in the file itself.
std::string commented_spec(const Joint& joint);

/// "> 0, N/m" or the words of a choice: what a key takes.
std::string allowed_values(const Key& key, Units units);

}  // namespace stickslip
