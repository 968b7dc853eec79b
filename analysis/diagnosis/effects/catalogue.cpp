#include "analysis/diagnosis/effects/catalogue.h"

#include <array>

namespace stickslip::gap {

bool main_friction_on_motor(const Joint& joint)
{
    Joint j = joint;
    return is_two_mass(j) && &main_friction(j) == &j.frictions.motor;
}

bool main_friction_on_link(const Joint& joint)
{
    return is_two_mass(joint) && !main_friction_on_motor(joint);
}

std::span<const Effect> effects()
{
    static const std::array catalogue{
        coulomb_level(),
        viscous(),
        stribeck(),
        asymmetric_friction(),
        load_dependent_friction(),
        presliding(),
        frictional_memory(),
        position_dependent_friction(),
        friction_drift(),
        inertia(),
        constant_load(),
        gravity(),
        cogging(),
        backlash(),
        compliance(),
        effort_gain(),
        saturation(),
        supply_sag(),
        actuator_lag(),
        delay(),
        velocity_filter(),
        gain_k_p(),
        gain_k_v(),
        gain_k_i(),
        feed_forward(),
        dead_zone(),
        quantisation(),
        sensor_offset(),
        periodic_disturbance(),
    };
    return catalogue;
}

}  // namespace stickslip::gap
