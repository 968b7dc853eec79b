// The makers of the effects, one a file.
#pragma once
#include "analysis/diagnosis/fit/effect.h"

namespace stickslip::gap {

Effect coulomb_level();
Effect viscous();
Effect stribeck();
Effect asymmetric_friction();
Effect load_dependent_friction();
Effect presliding();
Effect frictional_memory();
Effect position_dependent_friction();
Effect friction_drift();
Effect inertia();
Effect constant_load();
Effect gravity();
Effect cogging();
Effect backlash();
Effect compliance();
Effect effort_gain();
Effect saturation();
Effect supply_sag();
Effect actuator_lag();
Effect delay();
Effect velocity_filter();
Effect gain_k_p();
Effect gain_k_v();
Effect gain_k_i();
Effect feed_forward();
Effect dead_zone();
Effect quantisation();
Effect sensor_offset();
Effect periodic_disturbance();

/// Of two masses, which one has the main_friction(): the other one may be documented wrongly as well.
bool main_friction_on_motor(const Joint& joint);
bool main_friction_on_link(const Joint& joint);

}  // namespace stickslip::gap
