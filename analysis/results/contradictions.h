// Whether an answer of the diagnosis agrees with its own numbers: probabilities, shares, ceiling, remainder and gap are
// computed in different places, and say the same thing.
#pragma once
#include "analysis/results/diagnosis.h"

#include <string_view>
#include <vector>

namespace stickslip {

/// What contradicts what, by stable names; empty for an answer that agrees with itself.
std::vector<std::string_view> contradictions_in(const Diagnosis& diagnosis);

}  // namespace stickslip
