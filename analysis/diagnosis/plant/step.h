// One time step of a joint with sticking: leapfrog in position, implicit in what resists. For packs of joints: where a
// body sticks, stops or breaks away is chosen lane by lane.
#pragma once
#include "analysis/diagnosis/plant/joints.h"

namespace stickslip::gap {

template <class P>
struct State {
    P motor_position = 0, motor_velocity = 0;
    P link_position = 0, link_velocity = 0;  ///< two masses only
    FrictionState<P> motor, link;
    P acceleration = 0;  ///< of the last step, predicts the mid-step speed
    P driven_apart = 0;  ///< two masses: relative acceleration by all but spring and damper, of the last step
    P lagged = 0;        ///< command behind the actuator's lag
    P followed = 0;      ///< where the follower of an unmodelled force is
};

/// What a time step of this length needs of joints, divided once for all steps of a tick.
template <class P>
struct StepLength {
    P h = 1, per_h = 1;
    P motor_mobility = 0, link_mobility = 0;  ///< step over inertia
    P per_ratio = 1;
    /// Two masses: how far ahead the damper is taken, what of spring and damper is left by what they do until there,
    /// and the relative acceleration per force of the spring.
    P ahead = 0, left = 0, per_force = 0;
    SlidingStep<P> motor, link;
    StepLength() {}
    template <class K>
    StepLength(const Joints<P, K>& p, const P& step)
        : h(step), per_h(P(1.0) / step), motor_mobility(step / p.motor_inertia)
    {
        if (!p.kind.two_mass) return;
        link_mobility = step / p.link_inertia;
        per_ratio = P(1.0) / p.ratio;
        motor = {p.motor.coulomb, p.motor.viscous, motor_mobility};
        link = {p.link.coulomb, p.link.viscous, link_mobility};
        per_force = apart_per_force(p.motor_inertia, p.link_inertia, p.ratio);
        // in the middle of the step, which is of second order, unless it is long for the damper: then at its end
        const P damped = h * p.damping * per_force;
        ahead = select(damped < P(1.0), 0.5 * h, h);
        left = P(1.0) / (1.0 + ahead * p.damping * per_force);
    }
};

/// All that pushes the link from outside.
template <class P, class K>
P outside_force(const Joints<P, K>& p, State<P>& s, const P& q, const P& v, const P& t)
{
    P force = load_force(p.load, q, t);
    if (!p.kind.free) return force;
    for (int lane = 0; lane < P::lanes; ++lane) {
        const FreeForce& free = *p.free[lane];
        const double followed = std::clamp(s.followed[lane], q[lane] - free.play, q[lane] + free.play);
        s.followed.set(lane, followed);
        force.set(lane, force[lane] + free.at(followed, v[lane]));
    }
    return force;
}

/// Single mass. Constant forces, sliding, stopping and breaking away inside the step are exact; the rest is second
/// order.
template <class P, class K>
void step_single(const Joints<P, K>& p, State<P>& s, const PushOf<P>& drive, const P& t, const StepLength<P>& length)
{
    const P h = length.h, mobility = length.motor_mobility, zero(0.0), one(1.0);
    const P v = s.motor_velocity, middle = s.motor_position + 0.5 * h * v;
    const auto& r = p.motor;
    const P outside = outside_force(p, s, middle, v, t + 0.5 * h), force = drive.push + outside;
    const Surroundings<P> at{middle, drive.at(v), -outside, force - drive.drag * v};
    if (r.has.bristles) {
        s.motor_velocity = friction_step(r, s.motor, v, force - drive.drag * v, mobility, h, at);
        s.motor_position = middle + 0.5 * h * s.motor_velocity;
        return;
    }
    const auto moving = v != zero;
    P direction = copysign(one, select(moving, v, force));
    const P speed = max(zero, direction * (v + 0.5 * h * s.acceleration));
    P level = resistance(r, s.motor, select(moving, speed, zero), direction, at);
    const auto held = ~moving & (abs(force) <= level);
    if (const auto leaves = ~moving & (level < abs(force)); r.has.stribeck && any(leaves))
        level = select(leaves, leaving_level(r, s.motor, level, direction, force, mobility, at), level);
    const P slope = 0.5 * mobility * (viscous(r, direction) + drive.drag);
    P next = (v * (1.0 - slope) + mobility * (force - direction * level)) / (1.0 + slope);
    P travelled = 0.5 * h * (v + next);
    if (const auto stops = moving & (next * direction < zero); any(stops)) {
        // stops inside the step; its remainder starts from standstill
        const P part = v / (v - next);
        direction = copysign(one, force);
        level = resistance(r, s.motor, zero, direction, at);
        const P rest = (1.0 - part) * mobility;
        const P sliding = r.has.stribeck ? leaving_level(r, s.motor, level, direction, force, rest, at) : level;
        const P last = select(level < abs(force), rest * (force - direction * sliding), zero);
        travelled = select(stops, 0.5 * h * part * v + 0.5 * h * (1.0 - part) * last, travelled);
        next = select(stops, last, next);
    }
    next = select(held, zero, next);
    travelled = select(held, zero, travelled);
    s.motor_position = s.motor_position + travelled;
    s.motor_velocity = next;
    s.acceleration = (next - v) * length.per_h;
    remember(r, s.motor, abs(next), h);
}

/// Deflection beyond the backlash, positive when the motor leads.
template <class P>
P beyond_backlash(const P& deflection, const P& backlash)
{
    const P half = 0.5 * backlash;
    return deflection - max(-half, min(deflection, half));
}

/// What the spring gives, its damper apart.
template <class P, class K>
P elastic(const Joints<P, K>& p, const P& stretch)
{
    if (!p.kind.hardens) return p.stiffness * stretch;
    return (p.stiffness + p.cubic_stiffness * stretch * stretch) * stretch;
}

/// Two masses and a spring. The damper is implicit, so that a stiff one stays stable; what else drives the masses apart
/// is taken from the last step, without which a resting spring would hold less than its deflection says.
template <class P, class K>
void step_two_mass(const Joints<P, K>& p, State<P>& s, const PushOf<P>& drive, const P& t, const StepLength<P>& length)
{
    const P h = length.h, per_ratio = length.per_ratio, zero(0.0);
    const P motor_middle = s.motor_position + 0.5 * h * s.motor_velocity;
    const P link_middle = s.link_position + 0.5 * h * s.link_velocity;
    const P apart = motor_middle * per_ratio - link_middle;
    const P rate = s.motor_velocity * per_ratio - s.link_velocity;
    const P soon = rate + length.ahead * s.driven_apart;
    P spring;
    if (p.kind.has_backlash) {
        const P stretch = beyond_backlash(apart, p.backlash);
        spring = length.left * (elastic(p, stretch) + p.damping * soon);
        spring = select(zero < spring * stretch, spring,
                        zero);  // contact cannot pull, and within the backlash there is none
    } else {
        spring = length.left * (elastic(p, apart) + p.damping * soon);
    }
    const P on_motor = drive.at(s.motor_velocity) - spring * per_ratio;
    const P on_link = spring + outside_force(p, s, link_middle, s.link_velocity, t + 0.5 * h);
    s.motor_velocity = p.motor.has.one_slope
                           ? length.motor(s.motor_velocity, on_motor)
                           : friction_step(p.motor, s.motor, s.motor_velocity, on_motor, length.motor_mobility, h,
                                           {motor_middle, spring * per_ratio});
    s.link_velocity = p.link.has.one_slope ? length.link(s.link_velocity, on_link)
                                           : friction_step(p.link, s.link, s.link_velocity, on_link,
                                                           length.link_mobility, h, {link_middle, spring});
    s.driven_apart = (s.motor_velocity * per_ratio - s.link_velocity - rate) * length.per_h + spring * length.per_force;
    s.motor_position = motor_middle + 0.5 * h * s.motor_velocity;
    s.link_position = link_middle + 0.5 * h * s.link_velocity;
}

}  // namespace stickslip::gap
