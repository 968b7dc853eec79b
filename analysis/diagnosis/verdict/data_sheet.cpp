#include "analysis/diagnosis/verdict/data_sheet.h"

#include <algorithm>

namespace stickslip::gap {
namespace {

/// Whose effort follows from k_t and resistance, so that its effort_gain is a pure factor.
bool is_motor(const Joint& joint)
{
    return joint.actuator.kind == ActuatorKind::dc_motor;
}

bool is_cascade(const Joint& joint)
{
    return joint.control.structure == Structure::cascade;
}

constexpr SheetNumber sheet[] = {
    {"asymmetric-friction", "Coulomb level, positive direction", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)) + main_friction(j).asymmetry.coulomb; }},
    {"asymmetric-friction", "Coulomb level, negative direction", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)) - main_friction(j).asymmetry.coulomb; }},
    {"asymmetric-friction", "viscous slope, positive direction", Quantity::damping,
     [](Joint& j) { return viscous_slope(main_friction(j)) + main_friction(j).asymmetry.viscous; }},
    {"asymmetric-friction", "viscous slope, negative direction", Quantity::damping,
     [](Joint& j) { return viscous_slope(main_friction(j)) - main_friction(j).asymmetry.viscous; }},
    {"coulomb-level", "Coulomb level", Quantity::effort, [](Joint& j) { return coulomb_force(main_friction(j)); }},
    {"coulomb-level", "Coulomb level on the link", Quantity::effort,
     [](Joint& j) { return coulomb_force(j.frictions.link); }, "link"},
    {"coulomb-level", "Coulomb level on the motor", Quantity::effort,
     [](Joint& j) { return coulomb_force(j.frictions.motor); }, "motor"},
    {"friction-drift", "Coulomb level at the start", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)); }},
    {"friction-drift", "Coulomb level in the end", Quantity::effort,
     [](Joint& j) { return coulomb_force(main_friction(j)) + main_friction(j).drift.change; }},
    {"viscous", "viscous slope", Quantity::damping, [](Joint& j) { return viscous_slope(main_friction(j)); }},
    {"viscous", "viscous slope on the link", Quantity::damping,
     [](Joint& j) { return viscous_slope(j.frictions.link); }, "link"},
    {"viscous", "viscous slope on the motor", Quantity::damping,
     [](Joint& j) { return viscous_slope(j.frictions.motor); }, "motor"},
    {"inertia", "inertia", Quantity::inertia, [](Joint& j) { return j.mechanism.inertia; }},
    {"inertia", "link inertia", Quantity::inertia, [](Joint& j) { return j.mechanism.link_inertia; }, "link"},
    {"inertia", "motor inertia", Quantity::inertia, [](Joint& j) { return j.mechanism.motor_inertia; }, "motor"},
    {"constant-load", "constant load", Quantity::effort, [](Joint& j) { return j.load.constant; }},
    {"gravity", "gravity amplitude", Quantity::effort, [](Joint& j) { return j.load.gravity_amplitude; }},
    {"cogging", "cogging amplitude", Quantity::effort, [](Joint& j) { return j.load.cogging.amplitude; }},
    {"periodic-disturbance", "amplitude of the periodic force", Quantity::effort,
     [](Joint& j) { return j.load.disturbance.amplitude; }},
    {"position-dependent-friction", "amplitude over the position", Quantity::effort,
     [](Joint& j) { return main_friction(j).ripple.amplitude; }},
    {"stribeck", "friction at rest above the Coulomb level", Quantity::effort,
     [](Joint& j) { return stribeck_peak(main_friction(j)); }},
    {"stribeck", "Stribeck velocity", Quantity::velocity, [](Joint& j) { return stribeck_velocity(main_friction(j)); }},
    {"load-dependent-friction", "friction per transmitted effort", Quantity::number,
     [](Joint& j) { return main_friction(j).load_coefficient; }},
    {"load-dependent-friction", "friction per effort at the load, driving it", Quantity::number,
     [](Joint& j) { return j.friction.gear.forward; }, "gear"},
    {"load-dependent-friction", "friction per effort at the load, driven by it", Quantity::number,
     [](Joint& j) { return j.friction.gear.backward; }, "gear"},
    {"presliding", "bristle stiffness", Quantity::stiffness,
     [](Joint& j) { return main_friction(j).bristle.stiffness; }},
    {"frictional-memory", "direct effect A", Quantity::effort, [](Joint& j) { return main_friction(j).memory.A; }},
    {"frictional-memory", "evolution effect B", Quantity::effort, [](Joint& j) { return main_friction(j).memory.B; }},
    {"frictional-memory", "slip length L", Quantity::position, [](Joint& j) { return main_friction(j).memory.L; }},
    {"frictional-memory", "time lag of the friction", Quantity::time,
     [](Joint& j) { return main_friction(j).memory.lag; }, "lag"},
    {"frictional-memory", "time lag of the friction", Quantity::time,
     [](Joint& j) { return main_friction(j).memory.lag; }, "lag-of-curve"},
    {"backlash", "backlash", Quantity::position, [](Joint& j) { return j.mechanism.transmission.backlash; }},
    {"compliance", "transmission stiffness", Quantity::stiffness,
     [](Joint& j) { return j.mechanism.transmission.stiffness; }},
    {"compliance", "transmission damping", Quantity::damping,
     [](Joint& j) { return j.mechanism.transmission.damping; }},
    {"effort-gain", "effort per unit of the drive signal", Quantity::effort,
     [](Joint& j) { return is_motor(j) ? not_set : j.actuator.effort_gain; }},
    {"effort-gain", "effort per documented", Quantity::number,
     [](Joint& j) { return is_motor(j) ? j.actuator.effort_gain : not_set; }, "", true},
    {"effort-gain", "torque constant", Quantity::torque_constant, [](Joint& j) { return j.actuator.k_t; },
     "motor constant"},
    {"effort-gain", "voltage at the winding per documented", Quantity::number, [](Joint& j) { return j.actuator.k_t; },
     "drive", true},
    {"effort-gain", "back-EMF constant", Quantity::back_emf, [](Joint& j) { return j.actuator.k_e; }, "back-emf"},
    {"saturation", "effort limit", Quantity::effort, [](Joint& j) { return j.actuator.limit; }},
    {"saturation", "limit of the command", Quantity::command, [](Joint& j) { return j.control.effort_limit; }},
    {"supply-sag", "source resistance", Quantity::resistance, [](Joint& j) { return j.actuator.supply_resistance; },
     "motor"},
    {"supply-sag", "effort that pulls the supply down", Quantity::effort,
     [](Joint& j) { return j.actuator.sag_effort; }, "effort"},
    {"actuator-lag", "time constant of the actuator", Quantity::time, [](Joint& j) { return j.actuator.lag; }},
    {"actuator-lag", "time constant of the actuator", Quantity::time, [](Joint& j) { return j.actuator.lag; },
     "with-dead-time"},
    {"actuator-lag", "dead time of the command", Quantity::time, [](Joint& j) { return j.control.delay; },
     "with-dead-time"},
    {"delay", "dead time of the command", Quantity::time, [](Joint& j) { return j.control.delay; }},
    {"delay", "dead time of the command", Quantity::time, [](Joint& j) { return j.control.delay; }, "with-lag"},
    {"delay", "time constant of the actuator", Quantity::time, [](Joint& j) { return j.actuator.lag; }, "with-lag"},
    {"delay", "dead time of the reading", Quantity::time, [](Joint& j) { return j.sensor.delay; }, "of-the-reading"},
    {"velocity-filter", "time constant of the velocity filter", Quantity::time,
     [](Joint& j) { return j.control.velocity_estimate.tau; }},
    {"gain-k_p", "k_p", Quantity::position_gain, [](Joint& j) { return is_cascade(j) ? not_set : j.control.k_p; }},
    {"gain-k_p", "position gain of the cascade", Quantity::rate,
     [](Joint& j) { return is_cascade(j) ? j.control.position_gain : not_set; }},
    {"gain-k_v", "k_v", Quantity::velocity_gain, [](Joint& j) { return is_cascade(j) ? not_set : j.control.k_v; }},
    {"gain-k_v", "velocity gain of the cascade", Quantity::velocity_gain,
     [](Joint& j) { return is_cascade(j) ? j.control.velocity_gain : not_set; }},
    {"gain-k_i", "k_i", Quantity::integral_gain, [](Joint& j) { return is_cascade(j) ? not_set : j.control.k_i; }},
    {"gain-k_i", "integral gain of the velocity loop", Quantity::position_gain,
     [](Joint& j) { return is_cascade(j) ? j.control.velocity_integral_gain : not_set; }},
    {"gain-k_i", "reset time of the velocity loop", Quantity::time,
     [](Joint& j) { return is_cascade(j) ? j.control.velocity_reset_time : not_set; }},
    {"gain-k_i", "limit of the integral", Quantity::command, [](Joint& j) { return j.control.integral_limit; },
     "limit"},
    {"feed-forward", "Coulomb feed-forward", Quantity::command, [](Joint& j) { return j.control.feed_forward.coulomb; },
     "coulomb"},
    {"feed-forward", "acceleration feed-forward", Quantity::acceleration_gain,
     [](Joint& j) { return j.control.feed_forward.acceleration; }, "acceleration"},
    {"feed-forward", "Coulomb feed-forward", Quantity::command, [](Joint& j) { return j.control.feed_forward.coulomb; },
     "undocumented-coulomb"},
    {"feed-forward", "acceleration feed-forward", Quantity::acceleration_gain,
     [](Joint& j) { return j.control.feed_forward.acceleration; }, "undocumented-acceleration"},
    {"feed-forward", "Coulomb feed-forward", Quantity::command, [](Joint& j) { return j.control.feed_forward.coulomb; },
     "undocumented"},
    {"feed-forward", "acceleration feed-forward", Quantity::acceleration_gain,
     [](Joint& j) { return j.control.feed_forward.acceleration; }, "undocumented"},
    {"feed-forward", "share of the reference's velocity", Quantity::number,
     [](Joint& j) { return j.control.feed_forward.velocity; }, "velocity"},
    {"dead-zone", "half of the dead zone", Quantity::position, [](Joint& j) { return j.control.dead_zone; }},
    {"quantisation", "encoder step", Quantity::position, [](Joint& j) { return j.sensor.encoder_quantum; }},
    {"sensor-offset", "reading less position", Quantity::position, [](Joint& j) { return j.sensor.position_offset; },
     "offset"},
    {"sensor-offset", "reading per displacement", Quantity::number, [](Joint& j) { return j.sensor.position_scale; },
     "scale"},
};

}  // namespace

std::span<const SheetNumber> data_sheet()
{
    return sheet;
}

bool is_about(const SheetNumber& number, const Effect& effect, const EffectForm& form)
{
    if (number.effect != effect.name) return false;
    const bool has_line = std::ranges::any_of(
        sheet, [&](const SheetNumber& n) { return n.effect == effect.name && !n.form.empty() && n.form == form.name; });
    return has_line ? number.form == form.name : number.form.empty();
}

}  // namespace stickslip::gap
