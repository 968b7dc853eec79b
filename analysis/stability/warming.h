// What drift of friction may still add.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// What friction that drifts takes at most beyond the present one, in joint coordinates: what falls adds nothing.
double warming(const Joint& joint);

}  // namespace stickslip
