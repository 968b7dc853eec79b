// Edits of a joint that effects are made of, for any law and any model that has what they change.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip::gap {

/// The friction that an edit means: the joint's own, or of the body that carries most of it.
Friction& main_friction(Joint& joint);
/// Changes the Coulomb level of any law that has one; never below zero.
void shift_coulomb(Friction& friction, double change);
double coulomb_force(const Friction& friction);
double viscous_slope(const Friction& friction);
/// Changes the viscous slope of any law that has one; never below zero.
void shift_viscous(Friction& friction, double change);
/// Turns a law without a Stribeck peak into the same law with one.
void set_stribeck(Friction& friction, double c2, double c3, double c4);
/// The c2 of a law with a Stribeck peak, 0 of others.
double stribeck_peak(const Friction& friction);
/// Its c3, NaN of others.
double stribeck_velocity(const Friction& friction);
/// Changes c2; a law without a peak stays as it is.
void set_stribeck_peak(Friction& friction, double c2);
/// Divides a single mass into motor and link with a spring. This share of its Coulomb level and viscous slope goes to
/// the link, all other terms of its friction stay with the motor; the load acts on the link.
void divide_mass(Joint& joint, double motor_share, double stiffness, double damping_ratio, double link_friction_share);
/// Adds sine·sin(x) + cosine·cos(x) to amplitude·sin(x + phase).
void add_wave(double& amplitude, double& phase, double sine, double cosine);
bool is_single_mass(const Joint& joint);
bool is_two_mass(const Joint& joint);

}  // namespace stickslip::gap
