// A joint that cannot slide under its limits, said before anything else is.
#pragma once
#include "analysis/joint/joint.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip {

/// To standard error, with the place of the limit; nothing where the limits of the joint leave its steady sliding. The
/// answer itself stays undecided: another velocity of a map may slide.
void say_no_sliding(const std::filesystem::path& file, const std::vector<std::string>& settings, const Joint& joint);

}  // namespace stickslip
