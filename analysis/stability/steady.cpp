#include "analysis/stability/steady.h"

#include "analysis/joint/rules.h"
#include "analysis/joint/steady_output.h"
#include "analysis/stability/effort_limits.h"
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/real_loop.h"

namespace stickslip {
namespace {

/// Why this body cannot slide steadily at V, or none.
Reason obstacle(const Friction& friction, double V)
{
    if (V == 0 || (V < 0 && info(friction.law).needs_motion)) return Reason::law_needs_motion;
    return has_response(friction) ? Reason::none : Reason::unsupported;
}

bool loaded_by_effort(const Chain& chain)
{
    for (int i = 0; i < chain.bodies; ++i)
        if (chain.body[i].friction->load_coefficient != 0) return true;
    return false;
}

/// Neighbours beside delayed friction have no search for their roots. A normal load that follows the
/// transmitted effort needs a transmission, and has no form here that its state would follow.
Reason coupling_obstacle(const Joint& joint, const Chain& chain)
{
    const auto& load = joint.normal;
    const bool by_effort = load.from_load != 0 || loaded_by_effort(chain);
    // in force control the springs go on being stretched, so that such friction has no steady value
    const bool steady = chain.bodies > 1 && joint.control.kind == ControlKind::position;
    if (by_effort && chain.bodies > 1 && !steady) return Reason::unsupported;
    if (load.from_load != 0 && (chain.bodies == 1 || load.alpha != 0)) return Reason::unsupported;
    if (joint.neighbour.size == 0) return Reason::none;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& law = info(chain.body[i].friction->law);
        if (law.needs_history || law.linear_only) return Reason::unsupported;
    }
    return Reason::none;
}

}  // namespace

SteadySliding steady_sliding(const Joint& joint)
{
    SteadySliding s;
    s.velocity = commanded_velocity(joint);
    s.slides_at = sliding_velocity(joint);
    if (!is_set(s.velocity)) {
        s.reason = Reason::no_velocity;
        return s;
    }
    const Chain chain = chain_of(joint);
    s.reason = coupling_obstacle(joint, chain);
    if (s.reason == Reason::none && !obeys_rules(joint)) s.reason = Reason::impossible;
    if (s.reason != Reason::none) return s;
    s.friction = 0;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& body = chain.body[i];
        s.reason = obstacle(*body.friction, body.velocity(s.slides_at));
        if (s.reason != Reason::none) {
            s.friction = missing;
            return s;
        }
        s.friction += body.ratio * steady_force(*body.friction, body.velocity(s.slides_at));
    }
    double effort = s.friction;
    bool carries = true;
    if (loaded_by_effort(chain)) {
        effort = carried_efforts(joint, s.slides_at, 0)[0];
        for (int i = chain.bodies > 1 ? 1 : 0; i < chain.bodies; ++i)
            carries = carries && chain.body[i].friction->load_coefficient < 1;
    }
    if (joint.load.constant != 0 && joint.control.kind == ControlKind::position)
        effort = steady_effort(joint, s.slides_at);
    const double command = command_for(joint.actuator, effort, s.slides_at);
    // at V_0 as the controller reads it
    s.deflection = joint.control.kind == ControlKind::force
                       ? command / joint.control.k_p
                       : steady_output(joint.control, command, s.velocity, s.velocity).error;
    if (!std::isfinite(effort) || !carries) s.reason = Reason::no_steady_state;
    return s;
}

double displaced(const Joint& joint, const SteadySliding& sliding)
{
    const double per = joint.control.kind == ControlKind::position ? joint.sensor.position_scale : 1;
    return std::abs(sliding.deflection / per);
}

}  // namespace stickslip
