#include "analysis/stability/steady.h"

#include "analysis/joint/gains.h"
#include "analysis/stability/linear_joint.h"

namespace stickslip {
namespace {

/// Why this body cannot slide steadily at V, or none.
Reason obstacle(const Friction& friction, double V)
{
    if (V == 0 || (V < 0 && info(friction.law).needs_motion)) return Reason::law_needs_motion;
    return has_response(friction) ? Reason::none : Reason::unsupported;
}

/// Neighbours beside friction that answers late have no search for their roots, and a normal load that follows the
/// transmitted effort no linear form here.
Reason coupling_obstacle(const Joint& joint, const Chain& chain)
{
    if (joint.normal.from_load != 0) return Reason::unsupported;
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
    if (!is_set(s.velocity)) {
        s.reason = Reason::no_velocity;
        return s;
    }
    const Chain chain = chain_of(joint);
    s.reason = coupling_obstacle(joint, chain);
    if (s.reason != Reason::none) return s;
    s.friction = 0;
    for (int i = 0; i < chain.bodies; ++i) {
        const auto& body = chain.body[i];
        s.reason = obstacle(*body.friction, body.velocity(s.velocity));
        if (chain.bodies > 1 && body.friction->load_coefficient != 0) s.reason = Reason::unsupported;
        if (s.reason != Reason::none) {
            s.friction = missing;
            return s;
        }
        s.friction += body.ratio * steady_force(*body.friction, body.velocity(s.velocity));
    }
    // friction that grows with the transmitted effort T: T = f_ss + μ T
    const double share = 1 - (chain.bodies == 1 ? joint.friction.load_coefficient : 0);
    s.deflection = s.friction / share / gains_of(joint.control).k_p;
    if (!std::isfinite(s.friction) || !(share > 0)) s.reason = Reason::no_steady_state;
    return s;
}

}  // namespace stickslip
