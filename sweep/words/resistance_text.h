// What steady sliding takes an effort against, in words.
#pragma once
#include "analysis/joint/joint.h"

#include <string>

namespace stickslip {

constexpr int digits_near_limit = 6;  ///< a limit just below the friction reads otherwise like it

/// "friction 60 N, constant load -200 N, gravity up to 20 N, where it pulls most in a whole turn": no position is left
/// out, whatever part of the turn the joint may move in.
std::string resistance_words(const Joint& joint, double friction);

}  // namespace stickslip
