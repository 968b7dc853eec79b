// One time step of a joint with sticking: leapfrog in position, implicit in what resists.
#pragma once
#include "analysis/diagnosis/plant/friction_step.h"
#include "analysis/joint/drive.h"

namespace stickslip::gap {

struct State {
    double motor_position = 0, motor_velocity = 0;
    double link_position = 0, link_velocity = 0;  ///< two masses only
    RubState motor, link;
    double acceleration = 0;  ///< of the last step, predicts the mid-step speed
    double lagged = 0;        ///< command behind the actuator's lag
    double effort = 0;        ///< that reached the mechanism
    double followed = 0;      ///< where the follower of a force without a name is
};

/// What a time step of this length needs of a joint, divided once for all steps of a tick.
struct StepLength {
    double h, per_h;
    double motor_mobility, link_mobility;  ///< step over inertia
    double per_ratio;
    double stiff = 0, implicit = 0;  ///< two masses: of spring and damper, at the end of the step
    bool motor_glides, link_glides;
    Glide motor, link;
    StepLength(const Plant& p, double step)
        : h(step),
          per_h(1 / step),
          motor_mobility(step / p.motor_inertia),
          link_mobility(step / p.link_inertia),
          per_ratio(1 / p.ratio),
          motor_glides(glides(p.motor)),
          link_glides(glides(p.link)),
          motor(p.motor.coulomb, p.motor.viscous, motor_mobility),
          link(p.link.coulomb, p.link.viscous, link_mobility)
    {
        if (!p.two_mass) return;
        // inertia of the one against the other
        const double reduced = 1 / (1 / p.link_inertia + 1 / (p.ratio * p.ratio * p.motor_inertia));
        implicit = p.damping / (1 + h * p.damping / reduced);
        stiff = p.stiffness * (1 - h * implicit / reduced);
    }
};

/// All that pushes the link from outside.
inline double outside_force(const Plant& p, State& s, double q, double v, double t)
{
    const double force = load_force(p.load, q, t);
    if (!p.free.present) return force;
    s.followed = std::clamp(s.followed, q - p.free.play, q + p.free.play);
    return force + p.free.at(s.followed, v);
}

/// Single mass. Constant forces, sliding, stopping and breaking away inside the step are exact; the rest is second
/// order.
inline void step_single(const Plant& p, State& s, const Push& drive, double t, const StepLength& length)
{
    const double h = length.h, mobility = length.motor_mobility;
    double& v = s.motor_velocity;
    double& q = s.motor_position;
    const double middle = q + 0.5 * h * v;
    const Rubbing& r = p.motor;
    s.effort = drive.at(v);
    const Surroundings at{middle, s.effort};
    const double force = drive.push + outside_force(p, s, middle, v, t + 0.5 * h);
    if (r.bristle_stiffness > 0) {
        v = rub(r, s.motor, v, force - drive.drag * v, mobility, h, at);
        q = middle + 0.5 * h * v;
        return;
    }
    const double before = v;
    double direction = v != 0 ? std::copysign(1.0, v) : std::copysign(1.0, force);
    const double speed = std::max(0.0, direction * (v + 0.5 * h * s.acceleration));
    double level = resistance(r, s.motor, v != 0 ? speed : 0, direction, at);
    if (v == 0 && std::abs(force) <= level) {
        s.acceleration = 0;
        remember(r, s.motor, 0, h);
        return;
    }
    const double slope = 0.5 * mobility * (viscous(r, direction) + drive.drag);
    double next = (v * (1 - slope) + mobility * (force - direction * level)) / (1 + slope);
    double travelled = 0.5 * h * (v + next);
    if (next * direction < 0 && v != 0) {
        // stops inside the step; the rest of it starts from rest
        const double part = v / (v - next);
        travelled = 0.5 * h * part * v;
        direction = std::copysign(1.0, force);
        level = resistance(r, s.motor, 0, direction, at);
        next = 0;
        if (std::abs(force) > level) {
            next = (1 - part) * mobility * (force - direction * level);
            travelled += 0.5 * h * (1 - part) * next;
        }
    }
    q += travelled;
    v = next;
    s.acceleration = (next - before) * length.per_h;
    remember(r, s.motor, std::abs(travelled) * length.per_h, h);
}

/// Deflection beyond the play, positive when the motor leads.
inline double beyond_play(double deflection, double backlash)
{
    const double half = 0.5 * backlash;
    return deflection - std::clamp(deflection, -half, half);
}

/// Two masses and a spring. The damper is implicit, so that a stiff one stays stable.
inline void step_two_mass(const Plant& p, State& s, const Push& drive, double t, const StepLength& length)
{
    const double h = length.h, per_ratio = length.per_ratio;
    const double motor_middle = s.motor_position + 0.5 * h * s.motor_velocity;
    const double link_middle = s.link_position + 0.5 * h * s.link_velocity;
    const double stretch = beyond_play(motor_middle * per_ratio - link_middle, p.backlash);
    const bool touching = p.backlash == 0 || stretch != 0;
    const double rate = s.motor_velocity * per_ratio - s.link_velocity;
    double spring = touching ? length.stiff * stretch + length.implicit * rate : 0;
    if (p.backlash > 0 && spring * stretch < 0) spring = 0;  // contact cannot pull
    s.effort = drive.at(s.motor_velocity);
    const double on_motor = s.effort - spring * per_ratio;
    const double on_link = spring + outside_force(p, s, link_middle, s.link_velocity, t + 0.5 * h);
    s.motor_velocity = length.motor_glides ? length.motor(s.motor_velocity, on_motor)
                                           : rub(p.motor, s.motor, s.motor_velocity, on_motor, length.motor_mobility, h,
                                                 {motor_middle, spring * per_ratio});
    s.link_velocity = length.link_glides ? length.link(s.link_velocity, on_link)
                                         : rub(p.link, s.link, s.link_velocity, on_link, length.link_mobility, h,
                                               {link_middle, spring});
    s.motor_position = motor_middle + 0.5 * h * s.motor_velocity;
    s.link_position = link_middle + 0.5 * h * s.link_velocity;
}

}  // namespace stickslip::gap
