#include "analysis/joint/loop_side.h"

namespace stickslip {

double gear_ratio(const Joint& joint)
{
    const auto& m = joint.mechanism;
    switch (m.model) {
        case Model::single_mass:
            return 1;
        case Model::two_mass:
            return m.transmission.ratio;
        case Model::three_mass:
        case Model::lever:
            return m.motor_transmission.ratio * m.transmission_link.ratio;
    }
    return 1;
}

double reading_per_joint(const Joint& joint)
{
    return joint.control.feedback == Feedback::motor ? gear_ratio(joint) : 1;
}

Joint with_loop_at_joint(Joint joint)
{
    const double N = gear_ratio(joint), reading = reading_per_joint(joint);
    if (N == 1) return joint;
    auto& c = joint.control;
    auto& a = joint.actuator;
    // a drive signal that is an effort turns into one at the joint; volts and duty stay what they are
    const bool volts = a.kind == ActuatorKind::dc_motor;
    const double signal = volts ? 1 : N;
    for (double* gain :
         {&c.k_p, &c.k_v, &c.k_i, &c.velocity_gain, &c.velocity_integral_gain, &c.feed_forward.acceleration})
        *gain *= reading * signal;
    for (double* command : {&c.effort_limit, &c.integral_limit, &c.feed_forward.coulomb, &c.dither.amplitude})
        *command *= signal;
    for (double* effort : {&a.limit, &a.sag_effort, &joint.sensor.effort_noise}) *effort *= N;
    if (volts) a.k_t *= N, a.k_e *= N;
    for (double* length : {&c.dead_zone, &c.integral_band, &c.feed_forward.coulomb_speed, &c.feed_forward.coulomb_width,
                           &joint.sensor.encoder_quantum, &joint.sensor.position_noise, &joint.sensor.position_offset})
        *length /= reading;
    return joint;
}

}  // namespace stickslip
