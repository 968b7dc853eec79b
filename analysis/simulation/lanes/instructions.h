// Which instruction set the lanes of this process use.
#pragma once
#include "analysis/simulation/lanes/job.h"

#include <string_view>

namespace stickslip::lanes {

/// "baseline", "avx2", "avx512".
std::string_view name_of(Instructions set);

/// Keeps the lanes to a set that this processor has, to compute here what another machine computes. Throws
/// std::invalid_argument for a name of none, or of one that it lacks. To be called before any lanes run.
void use_instructions(std::string_view name);

}  // namespace stickslip::lanes
