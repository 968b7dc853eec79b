#include "analysis/results/quantity.h"

namespace stickslip {

namespace {

/// Of prismatic and of revolute joints.
struct TwoUnits {
    std::string_view slides, turns;
};

TwoUnits unit_of_command(Quantity quantity, Command command)
{
    const bool voltage = command == Command::voltage;
    switch (quantity) {
        case Quantity::position_gain:
            return voltage ? TwoUnits{"V/m", "V/rad"} : TwoUnits{"1/m", "1/rad"};
        case Quantity::velocity_gain:
            return voltage ? TwoUnits{"V·s/m", "V·s/rad"} : TwoUnits{"s/m", "s/rad"};
        case Quantity::integral_gain:
            return voltage ? TwoUnits{"V/(m·s)", "V/(rad·s)"} : TwoUnits{"1/(m·s)", "1/(rad·s)"};
        case Quantity::acceleration_gain:
            return voltage ? TwoUnits{"V·s²/m", "V·s²/rad"} : TwoUnits{"s²/m", "s²/rad"};
        default:
            return voltage ? TwoUnits{"V", "V"} : TwoUnits{"1", "1"};
    }
}

constexpr std::string_view command_names[] = {"effort", "voltage", "duty"};

}  // namespace

std::string_view name_of(Command command)
{
    return command_names[static_cast<int>(command)];
}

Command command_named(std::string_view name)
{
    for (const Command command : {Command::voltage, Command::duty})
        if (name == name_of(command)) return command;
    return Command::effort;
}

// In one piece: a table.
std::string_view unit_of(Quantity quantity, Units units)
{
    const bool turns = units.motion == Motion::revolute;
    const bool efforts = units.command == Command::effort;
    const auto of_command = [&] {
        const auto two = unit_of_command(quantity, units.command);
        return turns ? two.turns : two.slides;
    };
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
        case Quantity::command:
            if (!efforts) return of_command();
            [[fallthrough]];
        case Quantity::effort:
            return turns ? "N·m" : "N";
        case Quantity::effort_rate:
            return turns ? "N·m/s" : "N/s";
        case Quantity::impulse:
            return turns ? "N·m·s" : "N·s";
        case Quantity::position_gain:
            if (!efforts) return of_command();
            [[fallthrough]];
        case Quantity::stiffness:
            return turns ? "N·m/rad" : "N/m";
        case Quantity::integral_gain:
            if (!efforts) return of_command();
            return turns ? "N·m/(rad·s)" : "N/(m·s)";
        case Quantity::velocity_gain:
            if (!efforts) return of_command();
            [[fallthrough]];
        case Quantity::damping:
            return turns ? "N·m·s/rad" : "N·s/m";
        case Quantity::acceleration_gain:
            if (!efforts) return of_command();
            [[fallthrough]];
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
        case Quantity::cubic_stiffness:
            return turns ? "N·m/rad³" : "N/m³";
    }
    return "1";
}

}  // namespace stickslip
