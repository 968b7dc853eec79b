// The [axes] of a spec. Internal to sweep/files.
#pragma once
#include "analysis/joint/joint.h"
#include "analysis/results/stability_map.h"
#include "sweep/files/text/toml_input.h"
#include "sweep/files/toml/spec_file.h"

#include <vector>

namespace stickslip::files {

/// Every axis that is sound; the others are in `complaints`. Refuses duplicates and plans beyond the limits.
std::vector<Axis> read_axes(const toml::table& axes, Joint& joint, const PlanLimits& limits, bool nonlinear,
                            Complaints& complaints);

}  // namespace stickslip::files
