// A pack of joints that run through their records side by side: one lane each, the same terms in all.
#pragma once
#include "analysis/diagnosis/plant/friction_step.h"
#include "analysis/diagnosis/records/ticks.h"
#include "analysis/joint/drive.h"

#include <array>

namespace stickslip::gap {

/// What mechanisms of a pack have in common that decides which way a time step takes.
struct Form {
    bool two_mass = false, has_backlash = false, hardens = false, free = false;
    Terms motor, link;
    bool operator==(const Form&) const = default;
};

/// What else they have in common.
struct Surround {
    bool feedback_link = false, dead_time = false, lag = false;
    bool gravity = false, cogging = false, disturbance = false, sags = false, sensor_delay = false;
    ActuatorKind actuator = ActuatorKind::effort;
    DriveSignal signal = DriveSignal::voltage;
    bool operator==(const Surround&) const = default;

    /// Whether the same command drives the joint from tick to tick.
    bool holds() const { return !dead_time && !lag; }
};

/// What the joints of a pack have in common: which way a time step takes is the same in every lane.
struct Kind : Form, Surround {
    using MotorTerms = ToldTerms;
    using LinkTerms = ToldTerms;
    bool operator==(const Kind&) const = default;
};

/// The same of a form that is known as the program is built.
template <Form form>
struct KindOf : Surround {
    static constexpr bool two_mass = form.two_mass, has_backlash = form.has_backlash, hardens = form.hardens,
                          free = form.free;
    static constexpr Terms motor = form.motor, link = form.link;
    using MotorTerms = KnownTerms<form.motor>;
    using LinkTerms = KnownTerms<form.link>;
    explicit KindOf(const Surround& surround) : Surround(surround) {}
};

inline Kind kind_of(const Plant& p)
{
    Kind k;
    k.two_mass = p.two_mass, k.feedback_link = p.two_mass && p.feedback_link, k.has_backlash = p.backlash > 0;
    k.hardens = p.two_mass && p.cubic_stiffness > 0;
    k.free = p.free.present, k.dead_time = p.dead_time != 0, k.lag = p.actuator.lag > 0;
    k.gravity = p.load.gravity_amplitude != 0, k.cogging = p.load.cogging.acts();
    k.disturbance = p.load.disturbance.amplitude != 0, k.sags = p.actuator.sag_effort < infinity;
    k.sensor_delay = p.sensor.delay > 0;
    k.motor = terms_of(p.motor), k.link = terms_of(p.link);
    k.actuator = p.actuator.kind, k.signal = p.actuator.signal;
    return k;
}

/// The same along a record: a command that goes straight between ticks asks for what a delayed one does.
inline Kind kind_of(const Plant& p, const Ticks& ticks)
{
    Kind k = kind_of(p);
    k.dead_time = k.dead_time || ticks.straight_command;
    return k;
}

template <class P>
struct LoadOf {
    P constant = 0, gravity_amplitude = 0, gravity_phase = 0;
    struct {
        P amplitude = 0, periods = 1, phase = 0, second_amplitude = 0, second_phase = 0;
    } cogging;
    struct {
        P amplitude = 0, frequency = 1, phase = 0;
    } disturbance;
};

template <class P>
struct ActuatorOf {
    ActuatorKind kind = ActuatorKind::effort;
    DriveSignal signal = DriveSignal::voltage;
    P effort_gain = 1, limit = infinity, sag_effort = infinity;
    P k_t = 0, k_e = 0, resistance = 1, supply_resistance = 0;
};

template <class P, class K = Kind>
struct Joints {
    explicit Joints(const Kind& told) : kind(told) { motor.tell(told.motor), link.tell(told.link); }
    K kind;
    P motor_inertia = 1, link_inertia = 1, stiffness = 1, cubic_stiffness = 0, damping = 0, ratio = 1, backlash = 0;
    FrictionPack<P, typename K::MotorTerms> motor;
    FrictionPack<P, typename K::LinkTerms> link;
    LoadOf<P> load;
    ActuatorOf<P> actuator;
    P position_scale = 1, position_offset = 0, effort_scale = 1, sensor_delay = 0;
    std::array<const FreeForce*, P::lanes> free{};

    /// Puts this joint, of this kind, into a lane. It must outlive the lane.
    void load_lane(int lane, const Plant& p);
};

template <class P, class T>
void load_frictions(FrictionPack<P, T>& to, int lane, const FlatFriction& r)
{
    to.coulomb.set(lane, r.coulomb), to.viscous.set(lane, r.viscous);
    to.stribeck.set(lane, r.stribeck), to.stribeck_velocity.set(lane, r.stribeck_velocity);
    to.exponent.set(lane, r.exponent);
    to.asymmetric_coulomb.set(lane, r.asymmetric_coulomb), to.asymmetric_viscous.set(lane, r.asymmetric_viscous);
    to.load_coefficient.set(lane, r.load_coefficient);
    to.gear_forward.set(lane, r.gear_forward), to.gear_backward.set(lane, r.gear_backward);
    to.gear_beyond.set(lane, r.gear_beyond);
    to.ripple.set(lane, r.ripple), to.ripple_periods.set(lane, r.ripple_periods);
    to.ripple_phase.set(lane, r.ripple_phase);
    to.second_ripple.set(lane, r.second_ripple), to.second_phase.set(lane, r.second_phase);
    to.drift.set(lane, r.drift), to.drift_time.set(lane, r.drift_time);
    to.bristle_stiffness.set(lane, r.bristle_stiffness), to.bristle_damping.set(lane, r.bristle_damping);
    to.A.set(lane, r.A), to.B.set(lane, r.B), to.L.set(lane, r.L), to.V_star.set(lane, r.V_star);
    to.lag.set(lane, r.lag), to.per_L.set(lane, r.per_L), to.per_V_star.set(lane, r.per_V_star);
}

template <class P, class K>
void Joints<P, K>::load_lane(int lane, const Plant& p)
{
    motor_inertia.set(lane, p.motor_inertia), link_inertia.set(lane, p.link_inertia);
    stiffness.set(lane, p.stiffness), cubic_stiffness.set(lane, p.cubic_stiffness), damping.set(lane, p.damping);
    ratio.set(lane, p.ratio), backlash.set(lane, p.backlash);
    load_frictions(motor, lane, p.motor), load_frictions(link, lane, p.link);
    load.constant.set(lane, p.load.constant);
    load.gravity_amplitude.set(lane, p.load.gravity_amplitude), load.gravity_phase.set(lane, p.load.gravity_phase);
    load.cogging.amplitude.set(lane, p.load.cogging.amplitude), load.cogging.periods.set(lane, p.load.cogging.periods);
    load.cogging.phase.set(lane, p.load.cogging.phase);
    load.cogging.second_amplitude.set(lane, p.load.cogging.second_amplitude);
    load.cogging.second_phase.set(lane, p.load.cogging.second_phase);
    load.disturbance.amplitude.set(lane, p.load.disturbance.amplitude);
    load.disturbance.frequency.set(lane, p.load.disturbance.frequency);
    load.disturbance.phase.set(lane, p.load.disturbance.phase);
    const Actuator& a = p.actuator;
    actuator.kind = a.kind, actuator.signal = a.signal;
    actuator.effort_gain.set(lane, a.effort_gain), actuator.limit.set(lane, a.limit);
    actuator.sag_effort.set(lane, a.sag_effort);
    actuator.k_t.set(lane, a.k_t), actuator.k_e.set(lane, a.k_e), actuator.resistance.set(lane, a.resistance);
    actuator.supply_resistance.set(lane, a.supply_resistance);
    position_scale.set(lane, p.sensor.position_scale), position_offset.set(lane, p.sensor.position_offset);
    effort_scale.set(lane, p.sensor.effort_scale);
    sensor_delay.set(lane, p.sensor.delay);
    free[static_cast<std::size_t>(lane)] = &p.free;
}

}  // namespace stickslip::gap
