#include "analysis/diagnosis/fit/joint_edits.h"

#include <algorithm>
#include <cmath>

namespace stickslip::gap {

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

double stribeck_peak(const Friction& friction)
{
    const auto* law = std::get_if<Stribeck>(&friction.law);
    return law ? law->c2 : 0;
}

double stribeck_velocity(const Friction& friction)
{
    const auto* law = std::get_if<Stribeck>(&friction.law);
    return law ? law->c3 : not_set;
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
    // bearings resist on either side; whatever else friction does stays with the drive and its gear
    const double level = link_friction_share * coulomb_force(joint.friction);
    const double slope = link_friction_share * viscous_slope(joint.friction);
    joint.frictions.motor = joint.friction;
    shift_coulomb(joint.frictions.motor, -level);
    shift_viscous(joint.frictions.motor, -slope);
    joint.frictions.link = {};
    joint.frictions.link.law = CoulombViscous{level, slope};
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
