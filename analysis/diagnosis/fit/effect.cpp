#include "analysis/diagnosis/fit/effect.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

namespace {

double unit_with(Scale scale, double effort, double velocity, double position)
{
    switch (scale) {
        case Scale::velocity:
            return velocity;
        case Scale::position:
            return position;
        case Scale::damping:
            return effort / velocity;
        case Scale::stiffness:
            return effort / position;
        case Scale::wave_number:
            return 1 / position;
        default:
            return effort;
    }
}

double on(const Reflected& body, Scale scale, const Scales& s)
{
    return unit_with(scale, s.effort * body.effort, s.velocity * body.motion, s.position * body.motion);
}

}  // namespace

double unit_of(Scale scale, const Scales& s)
{
    switch (scale) {
        case Scale::one:
            return 1;
        case Scale::effort:
        case Scale::velocity:
        case Scale::position:
        case Scale::damping:
        case Scale::stiffness:
        case Scale::wave_number:
            return on({}, scale, s);
        case Scale::friction_effort:
            return on(s.friction, Scale::effort, s);
        case Scale::friction_velocity:
            return on(s.friction, Scale::velocity, s);
        case Scale::friction_position:
            return on(s.friction, Scale::position, s);
        case Scale::friction_damping:
            return on(s.friction, Scale::damping, s);
        case Scale::friction_stiffness:
            return on(s.friction, Scale::stiffness, s);
        case Scale::friction_wave_number:
            return on(s.friction, Scale::wave_number, s);
        case Scale::load_effort:
            return on(s.load, Scale::effort, s);
        case Scale::load_velocity:
            return on(s.load, Scale::velocity, s);
        case Scale::load_position:
            return on(s.load, Scale::position, s);
        case Scale::load_wave_number:
            return on(s.load, Scale::wave_number, s);
        case Scale::peak_effort:
            return s.peak_effort;
        case Scale::tick:
            return s.tick;
        case Scale::duration:
            return s.duration;
        case Scale::inertia:
            return s.inertia;
        case Scale::angular_frequency:
            return 1;
        case Scale::command:
            return s.command;
    }
    return 1;
}

const Effect* effect_named(std::string_view name)
{
    for (const auto& e : effects())
        if (e.name == name) return &e;
    return nullptr;
}

double coulomb_force(const Friction& friction)
{
    return std::visit(
        [](const auto& law) -> double {
            if constexpr (requires { law.coulomb; })
                return law.coulomb;
            else if constexpr (requires { law.c0; })
                return law.c0;
            else if constexpr (requires { law.f0; })
                return law.f0;
            else
                return 0;
        },
        friction.law);
}

void shift_coulomb(Friction& friction, double change)
{
    std::visit(
        [change](auto& law) {
            if constexpr (requires { law.coulomb; })
                law.coulomb = std::max(0.0, law.coulomb + change);
            else if constexpr (requires { law.c0; })
                law.c0 = std::max(0.0, law.c0 + change);
            else if constexpr (requires { law.f0; })
                law.f0 = std::max(0.0, law.f0 + change);
        },
        friction.law);
}

double viscous_slope(const Friction& friction)
{
    return std::visit(
        [](const auto& law) -> double {
            if constexpr (requires { law.viscous; })
                return law.viscous;
            else if constexpr (requires { law.c1; })
                return law.c1;
            else
                return 0;
        },
        friction.law);
}

void shift_viscous(Friction& friction, double change)
{
    std::visit(
        [change](auto& law) {
            if constexpr (requires { law.viscous; })
                law.viscous = std::max(0.0, law.viscous + change);
            else if constexpr (requires { law.c1; })
                law.c1 = std::max(0.0, law.c1 + change);
        },
        friction.law);
}

void set_stribeck(Friction& friction, double c2, double c3, double c4)
{
    if (auto* plain = std::get_if<CoulombViscous>(&friction.law)) {
        Stribeck with;
        with.c0 = plain->coulomb;
        with.c1 = plain->viscous;
        friction.law = with;
    }
    if (auto* law = std::get_if<Stribeck>(&friction.law)) {
        law->c2 = c2;
        law->c3 = c3;
        law->c4 = c4;
    }
}

Friction& main_friction(Joint& joint)
{
    if (is_single_mass(joint)) return joint.friction;
    auto& f = joint.frictions;
    // at the joint's side the motor's friction counts N times
    const double reduction = joint.mechanism.transmission.ratio;
    return coulomb_force(f.link) > reduction * coulomb_force(f.motor) ? f.link : f.motor;
}

namespace {

/// The law with all its forces times `part`.
void scale_forces(Friction& friction, double part)
{
    std::visit(
        [part](auto& law) {
            if constexpr (requires { law.viscous; }) law.viscous *= part;
            if constexpr (requires { law.c1; }) law.c1 *= part, law.c2 *= part;
            if constexpr (requires {
                              law.A;
                              law.f0;
                          }) {
                law.A *= part;
                for (double& b : law.B) b *= part;
            }
        },
        friction.law);
    shift_coulomb(friction, (part - 1) * coulomb_force(friction));
    friction.asymmetry.coulomb *= part;
    friction.asymmetry.viscous *= part;
    friction.ripple.amplitude *= part, friction.ripple.second_amplitude *= part;
    friction.drift.change *= part;
    friction.bristle.stiffness *= part;
    friction.bristle.damping *= part;
    friction.memory.A *= part;
    friction.memory.B *= part;
}

}  // namespace

double stribeck_peak(const Friction& friction)
{
    const auto* law = std::get_if<Stribeck>(&friction.law);
    return law ? law->c2 : 0;
}

void set_stribeck_peak(Friction& friction, double c2)
{
    if (auto* law = std::get_if<Stribeck>(&friction.law)) law->c2 = c2;
}

void divide_mass(Joint& joint, double motor_share, double stiffness, double damping_ratio, double link_friction_share)
{
    Mechanism& m = joint.mechanism;
    const double total = m.inertia;
    m.model = Model::two_mass;
    m.motor_inertia = motor_share * total;
    m.link_inertia = (1 - motor_share) * total;
    const double reduced = motor_share * (1 - motor_share) * total;
    m.transmission = {};
    m.transmission.stiffness = stiffness;
    m.transmission.damping = 2 * damping_ratio * std::sqrt(stiffness * reduced);
    joint.frictions.motor = joint.frictions.link = joint.friction;
    scale_forces(joint.frictions.motor, 1 - link_friction_share);
    scale_forces(joint.frictions.link, link_friction_share);
}

void add_wave(double& amplitude, double& phase, double sine, double cosine)
{
    const double s = amplitude * std::cos(phase) + sine, c = amplitude * std::sin(phase) + cosine;
    amplitude = std::hypot(s, c);
    phase = amplitude > 0 ? std::atan2(c, s) : 0;
}

bool is_single_mass(const Joint& joint)
{
    return joint.mechanism.model == Model::single_mass;
}
bool is_two_mass(const Joint& joint)
{
    return joint.mechanism.model == Model::two_mass;
}

}  // namespace stickslip::gap
