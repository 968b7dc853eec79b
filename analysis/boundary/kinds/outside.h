// Where nothing lies within a range: what lies nearest beyond its ends.
#pragma once
#include "analysis/boundary/kinds/boundary.h"

namespace stickslip {

/// The nearest boundary beyond the ends of a located ray, as far as a factor of 1000 (linear theories), 30 (folds) or
/// 10 (outcomes) from them; at what range it was looked for. Only positive values are looked at. The precision of an
/// outcome is 1e-3 here.
OutsideOfRay nearest_outside(const Joint& joint, const LocatedRay& ray, const BoundaryRequest& request);

}  // namespace stickslip
