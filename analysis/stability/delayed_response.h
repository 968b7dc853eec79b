// The linear joint with delays or tables under a disturbance in time.
#pragma once
#include "analysis/stability/forced_response.h"

namespace stickslip {

/// forced_response of a joint whose kernel has impulses or a table. Between the force's samples and the kinks that an
/// impulse at the start leaves one and two delays later, it steps with the exact exponential of what is no delay, the
/// delayed part of the friction being a cubic over each step: an error of the fourth order in the step, at most a tenth
/// of the fastest time constant.
ForcedResponse delayed_response(const LinearJoint& joint, const SampledForce& force);

}  // namespace stickslip
