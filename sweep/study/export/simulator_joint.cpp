#include "sweep/study/export/simulator_joint.h"

#include "analysis/joint/commanded_velocity.h"
#include "analysis/joint/gains.h"
#include "analysis/joint/reduction.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip {
namespace {

/// The viscous slope that a law states by itself.
double own_viscous(const FrictionLaw& law)
{
    return std::visit(
        [](const auto& l) -> double {
            if constexpr (requires { l.viscous; }) return l.viscous;
            if constexpr (requires { l.c1; }) return l.c1;
            if constexpr (requires { l.sigma2; }) return l.sigma2;
            return 0;
        },
        law);
}

/// The Coulomb level that a law states by itself; not set: it has to be read off its curve at some speed.
double own_level(const FrictionLaw& law)
{
    return std::visit(
        [](const auto& l) -> double {
            if constexpr (requires { l.coulomb; }) return l.coulomb;
            if constexpr (requires { l.kinetic; }) return l.kinetic;
            if constexpr (requires { l.c0; }) return l.c0;
            return not_set;
        },
        law);
}

/// Level and slope of a law. Laws that fall or rise with the logarithm of speed are read at `speed`, so that the
/// simulator slides with the same friction there.
SimulatorFriction dry(const Friction& friction, double speed)
{
    SimulatorFriction d;
    const double load = friction.normal_load;
    d.viscous = load * own_viscous(friction.law);
    const double level = own_level(friction.law);
    if (is_set(level)) {
        d.coulomb = load * level;
    } else {
        const double V_star = std::visit(
            [](const auto& l) -> double {
                if constexpr (requires { l.V_star; }) return l.V_star;
                return not_set;
            },
            friction.law);
        d.speed = is_set(speed) ? std::abs(speed) : is_set(V_star) && V_star > 0 ? V_star : 1e-3;
        d.coulomb = std::max(0.0, steady_force(friction, d.speed) - d.viscous * d.speed);
    }
    const double rest = static_force(friction);
    d.breakaway = std::isfinite(rest) ? std::max(d.coulomb, rest) : d.coulomb;
    return d;
}

/// Seen from the joint's side of a gear that turns `ratio` times.
SimulatorFriction reflected(SimulatorFriction d, double ratio)
{
    d.coulomb *= ratio;
    d.breakaway *= ratio;
    d.viscous *= ratio * ratio;
    d.speed /= ratio;
    return d;
}

void add(SimulatorFriction& to, const SimulatorFriction& d)
{
    to.coulomb += d.coulomb;
    to.viscous += d.viscous;
    to.breakaway += d.breakaway;
    to.speed = std::max(to.speed, d.speed);
}

/// Bodies, gear and friction.
void take_mechanism(SimulatorJoint& s, Joint joint, const SplitOptions& options)
{
    if (joint.mechanism.model == Model::lever) joint = lever_to_three_mass(joint).joint;
    const double sliding = sliding_velocity(joint);  // V_0 is what the encoder reads of it
    const double speed = is_set(options.speed) ? options.speed : sliding != 0 ? sliding : not_set;
    s.speed_assumed = !is_set(speed);
    const auto& m = joint.mechanism;
    if (m.model == Model::single_mass) {
        s.link_inertia = is_set(options.link_inertia) ? options.link_inertia : m.inertia;
        if (s.link_inertia > m.inertia)
            throw std::invalid_argument("the link's inertia exceeds that of the joint, which includes it");
        s.armature = m.inertia - s.link_inertia;
        s.link = dry(joint.friction, speed);
        return;
    }
    const bool middle = m.model == Model::three_mass;
    const Transmission& gear = middle ? m.motor_transmission : m.transmission;
    const double turns = middle ? m.transmission_link.ratio : 1;
    s.ratio = gear.ratio * turns;
    s.armature = m.motor_inertia * s.ratio * s.ratio;
    s.link_inertia = m.link_inertia;
    const Transmission& spring = middle ? m.transmission_link : m.transmission;
    s.stiffness = spring.stiffness;
    s.damping = spring.damping;
    s.backlash = spring.backlash;
    s.motor = reflected(dry(joint.frictions.motor, speed * s.ratio), s.ratio);
    s.link = dry(joint.frictions.link, speed);
    if (!middle) return;
    s.armature += m.transmission_inertia * turns * turns;
    s.backlash += gear.backlash / turns;
    add(s.motor, reflected(dry(joint.frictions.transmission, speed * turns), turns));
}

/// Gains and limits. `shaft` is the effort at the motor's shaft per unit of the controller's output.
void take_drive(SimulatorJoint& s, const Joint& joint)
{
    const auto& c = joint.control;
    const auto& a = joint.actuator;
    double shaft = a.effort_gain;
    const double N = s.ratio;
    if (a.kind == ActuatorKind::dc_motor) {
        const double per_volt = a.effort_gain * a.k_t / a.resistance;
        shaft = a.signal == DriveSignal::duty ? per_volt * a.supply_voltage : per_volt;
        s.back_emf = per_volt * a.k_e * N * N;
        if (is_set(a.supply_voltage)) {
            s.stall_effort = std::abs(per_volt) * a.supply_voltage * N;
            if (a.k_e > 0) s.no_load_speed = a.supply_voltage / a.k_e / N;
        }
    }
    // a motor's encoder counts N times the joint's motion, and its shaft effort acts N times on the joint
    const double measured = c.feedback == Feedback::motor || joint.mechanism.model == Model::single_mass ? N : 1;
    const double loop = shaft * N * measured;
    s.feedback_link = measured == 1 && joint.mechanism.model != Model::single_mass && c.feedback == Feedback::link;
    const Gains gains = gains_of(c);
    s.effort_per_command = shaft * N;
    s.k_p = gains.k_p * loop;
    s.k_v = gains.k_v * loop;
    s.k_i = gains.k_i * loop;
    s.integral_limit = c.integral_limit * std::abs(shaft) * N;
    s.effort_limit = std::min({c.effort_limit * std::abs(shaft), a.limit, s.stall_effort / N}) * N;
    s.reference_velocity = c.reference_velocity;
    s.period = c.period;
    s.delay = joint.dead_time();
}

}  // namespace

SimulatorJoint simulator_joint(const Joint& joint, const SplitOptions& options)
{
    SimulatorJoint s;
    s.motion = joint.mechanism.motion;
    s.gravity_amplitude = joint.load.gravity_amplitude;
    s.gravity_phase = joint.load.gravity_phase;
    take_mechanism(s, joint, options);
    take_drive(s, joint);
    return s;
}

}  // namespace stickslip
