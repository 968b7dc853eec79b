#include "analysis/joint/commanded_velocity.h"

namespace stickslip {

double commanded_velocity(const Joint& joint)
{
    const auto& c = joint.control;
    const bool ramp = c.kind == ControlKind::force && is_set(c.force_rate);
    return ramp ? c.force_rate / (c.k_p + c.contact_stiffness) : c.V0;
}

}  // namespace stickslip
