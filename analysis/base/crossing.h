// Where roots cross the border of stability as a gain grows, and the gains between.
#pragma once
#include "analysis/base/field.h"

namespace stickslip {

struct Interval {
    double low, high;
};  ///< open

/// A gain at which roots cross the imaginary axis, or the unit circle of a sampled loop at e^{iωT}; direction +1 where
/// they turn unstable with rising gain.
struct Crossing {
    double k_p = not_set;
    double omega = not_set;
    int direction = 0;
};

}  // namespace stickslip
