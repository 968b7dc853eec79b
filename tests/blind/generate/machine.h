// The "real" machine of a sealed case, in this generator's own terms. It shares no code with the program under test:
// only the file formats of the joint and its records are common ground. SI units.
#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace blind {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// amplitude · sin(rate · x + phase), x a position (rate in 1/m or 1/rad) or a time (rate in rad/s).
struct Sine {
    double amplitude = 0, rate = 1, phase = 0;
};

/// Friction between one body and the ground.
struct DryFriction {
    double coulomb = 0, viscous = 0;
    double static_rise = 0, stribeck_velocity = 1, stribeck_exponent = 2;  ///< Stribeck: rise above Coulomb at rest
    double uneven_coulomb = 0,
           uneven_viscous = 0;          ///< half the difference of the two directions, + adds to positive motion
    double load_share = 0;              ///< friction per transmitted effort
    Sine ripple;                        ///< of the dry level over position
    double drift = 0, drift_time = 10;  ///< level grows by drift (1 − e^{−t/drift_time})
    double bristle_stiffness = 0, bristle_damping = 0;
    double direct = 0, evolution = 0, slip_length = 1, slip_velocity = 1;  ///< A, B, L, V* of rate-and-state friction
    double lag = 0;  ///< dry level answers speed this much later, s
};

/// A cause outside the catalogue. What the numbers mean depends on the kind; see outside.cpp.
struct Outside {
    enum class Kind {
        none,
        quadratic_drag,
        softening_ends,
        hardening_ends,
        cubic_spring,
        hysteretic_load,
        bumps,
        changing_inertia,
        random_force,
        local_obstacle,
    };
    Kind kind = Kind::none;
    double size = 0, where = 1, width = 1;
    std::uint64_t seed = 0;
};

struct Mechanism {
    int bodies = 1;          ///< 1, or 2: motor and link with a spring between
    double inertia[2] = {};  ///< motor (or only body), link
    double stiffness = 0, damping = 0, backlash = 0;
    DryFriction friction[2];
    double constant_load = 0;  ///< acts in the positive direction, on the link
    double gravity = 0, gravity_phase = 0;
    Sine cogging, disturbance;
    Outside outside;
};

/// From command to effort: dead time → lag → gain (or motor) → limit.
struct Drive {
    enum class Kind { effort, dc_voltage, dc_duty };
    Kind kind = Kind::effort;
    double dead_time = 0, lag = 0, gain = 1, limit = unlimited;
    double torque_constant = 0, back_emf = 0, resistance = 1, supply = unlimited, supply_resistance = 0;
    double sag_effort = unlimited;  ///< effort source: the share |effort| / sag_effort of the effort is lost
};

struct Controller {
    double period = 1e-3, k_p = 0, k_v = 0, filter = 0, limit = unlimited;
    int average = 1;
    bool reference_velocity = true;
};

struct Sensors {
    double quantum = 0, position_noise = 0, effort_noise = 0, offset = 0, scale = 1;
};

struct Machine {
    bool revolute = true;
    Mechanism mechanism;
    Drive drive;
    Controller controller;
    Sensors sensors;
};

}  // namespace blind
