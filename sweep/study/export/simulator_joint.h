// A joint in the few numbers that robot simulators have. Everything stands at the joint's side of the gear.
#pragma once
#include "analysis/joint/joint.h"

namespace stickslip {

/// Friction of one body as simulators know it: coulomb · sgn V + viscous · V.
struct SimulatorFriction {
    double coulomb = 0, viscous = 0;
    double breakaway = 0;  ///< largest friction at rest
    double speed = 0;      ///< at which the law was read for `coulomb`; 0: the law states the level itself
};

struct SimulatorJoint {
    Motion motion = Motion::prismatic;
    double link_inertia = 0;
    double armature = 0;                                                ///< N² J of the motor
    double ratio = 1, stiffness = infinity, damping = 0, backlash = 0;  ///< between motor and link
    SimulatorFriction motor, link;                                      ///< of one mass: all on the link
    double gravity_amplitude = 0, gravity_phase = 0;
    double k_p = 0, k_v = 0, k_i = 0, integral_limit = infinity;
    double effort_per_command = 1;  ///< at the joint, per unit of the controller's output
    double back_emf = 0;            ///< damping by a DC motor's back-EMF; comes on top of `motor.viscous`
    double effort_limit = infinity;
    double no_load_speed = infinity, stall_effort = infinity;  ///< DC motor at its supply voltage
    double period = not_set, delay = 0;
    bool reference_velocity = true, feedback_link = false;
    bool speed_assumed = false;  ///< friction was read at a velocity that nobody stated

    bool two_bodies() const { return armature > 0; }
    /// Motor and link as one rigid body.
    double inertia() const { return link_inertia + armature; }
    SimulatorFriction friction() const
    {
        return {motor.coulomb + link.coulomb, motor.viscous + link.viscous + back_emf, motor.breakaway + link.breakaway,
                std::max(motor.speed, link.speed)};
    }
};

struct SplitOptions {
    double link_inertia = not_set;  ///< single mass: what the robot's links have about this axis; the rest is armature
    double speed = not_set;  ///< at which laws without a Coulomb level of their own are read; not set: that of sliding
};

/// Throws std::invalid_argument where the link's inertia exceeds the joint's.
SimulatorJoint simulator_joint(const Joint& joint, const SplitOptions& options = {});

}  // namespace stickslip
