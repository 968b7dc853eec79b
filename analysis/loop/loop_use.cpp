#include "analysis/loop/loop_use.h"

#include "analysis/joint/gains.h"

namespace stickslip {
namespace {

/// Whether anything of the motion comes back to the motor.
bool feeds_back(const Joint& joint)
{
    return joint.control.kind == ControlKind::position || joint.control.force_gain != 0;
}

}  // namespace

LoopKind loop_kind(const Joint& joint)
{
    const auto& c = joint.control;
    const auto& a = joint.actuator;
    if (!feeds_back(joint)) return a.kind == ActuatorKind::dc_motor ? LoopKind::continuous : LoopKind::ideal;
    if (is_set(c.period)) return LoopKind::sampled;
    const bool late = c.delay > 0 || a.lag > 0 || c.velocity_estimate.tau > 0;
    const bool other = gains_of(c).k_i != 0 || a.effort_gain != 1 || joint.sensor.position_scale != 1 ||
                       a.kind == ActuatorKind::dc_motor;
    return late || other ? LoopKind::continuous : LoopKind::ideal;
}

Joint with_ideal_loop(Joint joint)
{
    joint = with_gains(std::move(joint));
    auto& c = joint.control;
    c.k_i = 0;
    c.period = not_set;
    c.delay = 0;
    c.velocity_estimate = {};
    c.effort_limit = infinity;
    c.dead_zone = 0;
    c.feed_forward = {};
    joint.actuator = {};
    joint.sensor = {};
    return joint;
}

}  // namespace stickslip
