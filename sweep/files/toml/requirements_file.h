// The [requirements] of a design, and uncertainties of a joint's numbers.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/design/design.h"
#include "analysis/joint/keys.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// Reads the [requirements] table of a spec or joint file, then `changes` (key=value, as on the command line). What
/// neither says comes from the joint: sensor.position_noise and encoder_quantum/√12, control.period, its velocity
/// estimate and its limits of effort. Throws BadInput with every error.
Requirements read_requirements(const std::filesystem::path& file, const Joint& joint,
                               const std::vector<std::string>& changes);

/// The keys of [requirements], each at its default.
std::vector<Key> requirement_keys();

/// "PATH=20%" or "PATH - PATH=0.2" for each uncertain number. Throws BadInput.
Uncertainty uncertainty_from(const Joint& joint, const std::vector<std::string>& texts);

}  // namespace stickslip
