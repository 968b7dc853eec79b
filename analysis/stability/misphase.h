// The sign of Im(a conj b) where rounding would decide it.
#pragma once
#include "analysis/stability/characteristic.h"

namespace stickslip {

/// misphase of a rational joint, computed again with some 34 digits where too few of a double's are left: the damping of
/// a stiff joint may enter it sixteen orders of magnitude below the springs.
double certain_misphase(const LinearJoint& joint, Gain gain, double omega);

}  // namespace stickslip
