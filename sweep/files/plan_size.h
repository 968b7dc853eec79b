// What a plan that is too large would have cost, in words. Internal to sweep/files.
#pragma once
#include "sweep/files/spec_file.h"

#include <string>

namespace stickslip::files {

/// "make 1e+15 points (about 128 PB of results and 317.1 years of computing), allowed are at most 2e+09"
std::string plan_size_text(double points, const PlanLimits& limits);

}  // namespace stickslip::files
