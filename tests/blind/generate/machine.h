// The "real" machine of a blind test case, in this generator's own terms. It shares no code with the program under
// test: only the file formats of the joint and its records are common ground. SI units.
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
    double second = 0;  ///< second harmonic, as a part of the first
};

inline constexpr int slip_elements = 4;

/// Friction between one body and the ground.
struct DryFriction {
    /// How the rise above Coulomb falls with speed s = |v|/v_s: e^{−s^n}, 1 − tanh s, 1/(1 + s²).
    enum class Shape { exponential, tanh, rational };
    double coulomb = 0, viscous = 0;
    double static_rise = 0, stribeck_velocity = 1, stribeck_exponent = 2;  ///< Stribeck: rise above Coulomb at rest
    Shape shape = Shape::exponential;
    double uneven_coulomb = 0,
           uneven_viscous = 0;          ///< half the difference of the two directions, + adds to positive motion
    double load_share = 0;              ///< friction per transmitted effort
    double back_driving = 1;            ///< by which the share is multiplied where the effort brakes the motion
    Sine ripple;                        ///< of the dry level over position
    double drift = 0, drift_time = 10;  ///< level grows by drift (1 − e^{−t/drift_time})
    bool to_document = false;           ///< instead the level begins off by the drift and ends as documented
    double bristle_stiffness = 0, bristle_damping = 0;
    int elements = 0;  ///< of Maxwell slip in place of the one bristle; the first body only
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
    double hardening = 0;  ///< the spring is stiffer by this part at one hardening_stretch, with its square
    double hardening_stretch = 1;
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

/// k_p (r − y) + k_v (ṙ − v) + k_i Σ T (r − y), or, as a cascade, velocity_gain w + velocity_integral Σ T w with
/// w = position_gain (r − y) + ṙ − v. Errors within the dead zone count as none; coulomb tanh(ṙ/coulomb_speed) is
/// added.
struct Controller {
    double period = 1e-3, k_p = 0, k_v = 0, filter = 0, limit = unlimited;
    int average = 1;
    bool reference_velocity = true;
    bool cascade = false;
    double k_i = 0, position_gain = 0, velocity_gain = 0, velocity_integral = 0;
    double dead_zone = 0, coulomb = 0, coulomb_speed = 1;
};

struct Sensors {
    double quantum = 0, position_noise = 0, effort_noise = 0, offset = 0, scale = 1;
    double colour = 0;  ///< correlation of the noise from reading to reading
    double spikes = 0;  ///< share of readings that are off by ten standard deviations more
};

struct Machine {
    bool revolute = true;
    double reduction = 1;  ///< motor motion per joint motion: changes how the motor's side is told, see geared.h
    Mechanism mechanism;
    Drive drive;
    Controller controller;
    Sensors sensors;
};

}  // namespace blind
