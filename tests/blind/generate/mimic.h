// Whether a cause outside the catalogue could pass for effects inside it.
#pragma once
#include "tests/blind/generate/setting.h"

namespace blind {

/// Share of the noise-free gap that the best linear combination of simple catalogue effects (Coulomb level, viscous
/// friction, asymmetry, load, gravity, inertia, load-dependent friction) explains. Near 1, "unknown" would not be fair.
double explained_by_catalogue(const Setting& setting, const std::vector<Machine>& truth);

}  // namespace blind
