// Elements to paste into the description of a robot, one writer a simulator.
#pragma once
#include "sweep/study/export/export.h"

#include <string>

namespace stickslip {

/// The text for the answer's simulator; it loads as it stands. `name` is that of the joint.
std::string simulator_text(const ExportAnswer& answer, const std::string& name);

namespace files {

std::string mjcf_text(const ExportAnswer& answer, const std::string& name);
std::string urdf_text(const ExportAnswer& answer, const std::string& name);
std::string sdf_text(const ExportAnswer& answer, const std::string& name);
std::string isaaclab_text(const ExportAnswer& answer, const std::string& name);
std::string ros2_control_text(const ExportAnswer& answer, const std::string& name);

/// A body about one axis that turns about −y (so that gravity along −z pulls as in joint.toml) or slides along x.
struct Pendulum {
    double mass = 1, x = 0, z = 0;  ///< centre of mass from the axis
    double own_inertia = 0;         ///< about the centre of mass
};

/// A body with this inertia about the axis. With gravity, half of the inertia is a point mass that hangs below it.
Pendulum pendulum(const SimulatorJoint& joint, double inertia);

/// The motor as a body of its own, where backlash parts it from the link, and its friction with the back-EMF.
Pendulum rotor_of(const SimulatorJoint& joint);
SimulatorFriction motor_friction(const SimulatorJoint& joint);

}  // namespace files
}  // namespace stickslip
