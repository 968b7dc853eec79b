#include "analysis/results/quantity.h"

namespace stickslip {

std::string_view unit_of(Quantity quantity, Motion motion)
{
    const bool turns = motion == Motion::revolute;
    switch (quantity) {
        case Quantity::number:
            return "1";
        case Quantity::time:
            return "s";
        case Quantity::rate:
            return "1/s";
        case Quantity::angular_frequency:
            return "rad/s";
        case Quantity::position:
            return turns ? "rad" : "m";
        case Quantity::velocity:
            return turns ? "rad/s" : "m/s";
        case Quantity::effort:
            return turns ? "N·m" : "N";
        case Quantity::effort_rate:
            return turns ? "N·m/s" : "N/s";
        case Quantity::impulse:
            return turns ? "N·m·s" : "N·s";
        case Quantity::stiffness:
            return turns ? "N·m/rad" : "N/m";
        case Quantity::integral_gain:
            return turns ? "N·m/(rad·s)" : "N/(m·s)";
        case Quantity::damping:
            return turns ? "N·m·s/rad" : "N·s/m";
        case Quantity::inertia:
            return turns ? "kg·m²" : "kg";
        case Quantity::per_position:
            return turns ? "1/rad" : "1/m";
        case Quantity::angle:
            return "rad";
        case Quantity::length:
            return "m";
        case Quantity::rotary_inertia:
            return "kg·m²";
        case Quantity::voltage:
            return "V";
        case Quantity::current:
            return "A";
        case Quantity::resistance:
            return "Ω";
        case Quantity::torque_constant:
            return turns ? "N·m/A" : "N/A";
        case Quantity::back_emf:
            return turns ? "V·s/rad" : "V·s/m";
        case Quantity::temperature:
            return "°C";
    }
    return "1";
}

}  // namespace stickslip
