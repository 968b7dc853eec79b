#include "analysis/stability/steady.h"

#include "analysis/stability/linear_friction.h"

namespace stickslip {

double commanded_velocity(const Joint& joint)
{
    const auto& c = joint.control;
    return c.kind == ControlKind::force && is_set(c.force_rate) ? c.force_rate / c.k_p : c.V0;
}

SteadySliding steady_sliding(const Joint& joint)
{
    SteadySliding s;
    s.velocity = commanded_velocity(joint);
    if (!is_set(s.velocity)) {
        s.reason = Reason::no_velocity;
        return s;
    }
    if (s.velocity == 0 || (s.velocity < 0 && info(joint.friction.law).needs_motion)) {
        s.reason = Reason::law_needs_motion;
        return s;
    }
    if (!has_response(joint.friction)) {
        s.reason = Reason::unsupported;
        return s;
    }
    s.friction = steady_force(joint.friction, s.velocity);
    // friction that grows with the transmitted effort T: T = f_ss + μ T
    const double share = 1 - joint.friction.load_coefficient;
    s.deflection = s.friction / share / joint.control.k_p;
    if (!std::isfinite(s.friction) || !(share > 0)) s.reason = Reason::no_steady_state;
    return s;
}

}  // namespace stickslip
