// What kind of thing a number is, and the unit it is written in. One table serves input checks, NetCDF attributes,
// chart labels and help. All numbers in memory are SI.
#pragma once
#include <string>
#include <string_view>

namespace stickslip {

/// How a joint moves: a prismatic joint reads m, N, kg where a revolute one reads rad, N·m, kg·m².
enum class Motion { prismatic, revolute };

/// What a controller puts out: an effort on the joint, or the signal of a motor's drive, in volts or as a share of the
/// supply.
enum class Command { effort, voltage, duty };

/// "effort", "voltage", "duty", as files have it.
std::string_view name_of(Command command);
/// The command of that name; any other name is an effort.
Command command_named(std::string_view name);

/// What the units of one joint's numbers depend on. units_of() of a joint (joint.h) knows both.
struct Units {
    Motion motion = Motion::prismatic;  ///< metres or radians
    Command command = Command::effort;  ///< what the controller puts out, whose unit gains have

    constexpr Units() = default;
    explicit constexpr Units(Motion moves, Command puts_out = Command::effort) : motion(moves), command(puts_out) {}
    friend constexpr bool operator==(const Units&, const Units&) = default;
};

/// The physical quantity of a number, from which its unit follows.
enum class Quantity {
    number,             ///< a ratio, an exponent, a count
    time,               ///< s
    rate,               ///< 1/s: growth rate, spectral abscissa
    angular_frequency,  ///< rad/s
    position,           ///< m | rad: displacement, slip distance, deflection
    velocity,           ///< m/s | rad/s
    effort,             ///< N | N·m
    effort_rate,        ///< N/s | N·m/s
    impulse,            ///< N·s | N·m·s: effort times time
    stiffness,          ///< N/m | N·m/rad: springs, kernel weights
    damping,            ///< N·s/m | N·m·s/rad: dampers, friction slopes
    inertia,            ///< kg | kg·m²
    per_position,       ///< 1/m | 1/rad: periods of a position-locked term times 2π
    angle,              ///< rad for every motion: a phase
    length,             ///< m for every motion: a lever arm
    rotary_inertia,     ///< kg·m² for every motion: the lever's own
    voltage,            ///< V
    current,            ///< A
    resistance,         ///< Ω
    torque_constant,    ///< N/A | N·m/A
    back_emf,           ///< V·s/m | V·s/rad
    temperature,        ///< °C
    command,            ///< what the controller puts out: N | N·m, V, or a number
    position_gain,      ///< command per position
    velocity_gain,      ///< command per velocity
    integral_gain,      ///< command per position and time
    acceleration_gain,  ///< command per acceleration: kg | kg·m² of efforts
    cubic_stiffness     ///< N/m³ | N·m/rad³: effort per cube of a deflection
};

/// The unit as it is printed: "N·m/rad" for a stiffness of Units(Motion::revolute); "1" for a plain number.
std::string_view unit_of(Quantity quantity, Units units);

}  // namespace stickslip
