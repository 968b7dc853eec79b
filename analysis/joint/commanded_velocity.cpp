#include "analysis/joint/commanded_velocity.h"

namespace stickslip {

double commanded_velocity(const Joint& joint)
{
    const auto& c = joint.control;
    const bool ramp = c.kind == ControlKind::force && is_set(c.force_rate);
    return ramp ? c.force_rate / (c.k_p + c.contact_stiffness) : c.V0;
}

double sliding_velocity(const Joint& joint)
{
    const double commanded = commanded_velocity(joint);
    return joint.control.kind == ControlKind::position ? commanded / joint.sensor.position_scale : commanded;
}

}  // namespace stickslip
