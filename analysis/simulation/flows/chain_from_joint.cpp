// The joints that a chain of bodies describes, and the reasons why others are none.
#include "analysis/simulation/flows/chain_flow.h"

#include "analysis/stability/steady.h"

#include <cmath>

namespace stickslip {

ChainOrReason chain_flow(const Joint& joint, bool with_delayed_friction)
{
    ChainOrReason result;
    auto& flow = result.flow;
    const auto sliding = steady_sliding(joint);
    result.reason = sliding.reason;
    if (result.reason != Reason::none) return result;
    const auto chain = chain_of(joint);
    flow.bodies = chain.bodies;
    flow.V0 = std::abs(sliding.slides_at);
    int next = 2 * chain.bodies;
    for (int i = 0; i < chain.bodies; ++i) {
        auto& b = flow.body[i];
        b.friction = *chain.body[i].friction;
        const auto about = info(b.friction.law);
        if (about.linear_only) result.reason = Reason::linear_only;
        b.delayed = std::holds_alternative<TimeLag>(b.friction.law);
        // memory on top of delayed friction has states that nothing here follows
        if (b.delayed && (!with_delayed_friction || states(b.friction) > 0)) result.reason = Reason::unsupported;
        if (has_unsteady_terms(b.friction, joint.load)) result.reason = Reason::unsupported;
        if (sliding.slides_at < 0) b.friction.asymmetry.coulomb *= -1, b.friction.asymmetry.viscous *= -1;
        b.inertia = chain.body[i].inertia;
        b.ratio = chain.body[i].ratio;
        b.speed = chain.body[i].speed * flow.V0;
        b.logarithmic = about.needs_motion;
        b.states = states(b.friction);
        b.first_state = next;
        next += b.states;
    }
    flow.total_states_ = next - 2 * chain.bodies;
    const auto& m = joint.mechanism;
    if (m.transmission.backlash + m.motor_transmission.backlash + m.transmission_link.backlash > 0 ||
        joint.normal.moves() || joint.neighbour.size > 0)
        result.reason = Reason::unsupported;
    if (result.reason != Reason::none) return result;
    for (int i = 0; i < chain.bodies; ++i) {
        auto& b = flow.body[i];
        b.steady_friction = steady_force(b.friction, b.ratio * b.speed);
    }
    flow.loop = linear_joint(joint, sliding.slides_at);
    for (int i = 0; i < chain.bodies; ++i) {
        auto& b = flow.body[i];
        const double V = b.ratio * b.speed;
        auto contact = direct_contact(b.friction, V);
        if (is_steep(contact, V)) {
            contact.A *= b.ratio;
            b.creep = creep_speed(contact, flow.stiffness(i, i), b.inertia, b.speed);
        }
        // viscous friction holds nothing: a body that stood still in balance would stay there for ever
        b.rests = b.creep > 0 || (can_rest(b.friction) && flow.static_force(i) > 0);
    }
    if (!flow.steady().allFinite() || !flow.scale().allFinite()) result.reason = Reason::not_finite;
    return result;
}

}  // namespace stickslip
