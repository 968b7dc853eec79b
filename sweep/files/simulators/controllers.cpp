// What takes gains and numbers alone: the actuator configuration of Isaac Lab, the controller parameters of
// ros2_control.
#include "sweep/files/simulators/simulator_text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip::files {

std::string isaaclab_text(const ExportAnswer& a, const std::string& name)
{
    const auto& j = a.joint;
    const auto f = j.friction();
    // a DC motor too: its back-EMF is in viscous_friction, and DCMotorCfg would take it off the limit once more
    const bool delayed = a.delay_steps > 0;
    const std::string kind = delayed ? "DelayedPDActuatorCfg" : "ImplicitActuatorCfg";
    std::string text = fmt::format(
        "# Isaac Lab 2.3 with Isaac Sim 5: friction is an effort [{0}]. For steps of {6:g} s (SimulationCfg.dt).\n"
        "# In `actuators` of an ArticulationCfg:\n"
        "from isaaclab.actuators import {1}\n\n"
        "actuators = {{\n"
        "    \"{2}\": {1}(\n"
        "        joint_names_expr=[\"{2}\"],\n"
        "        stiffness={3:.9g},{4}\n"
        "        damping={5:.9g},\n",
        unit_of(Quantity::effort, Units(j.motion)), kind, name, j.k_p,
        j.ratio != 1 ? fmt::format("  # at the motor's shaft, times N² = {:.9g}", j.ratio * j.ratio) : "", j.k_v,
        a.timestep);
    if (j.armature > 0) text += fmt::format("        armature={:.9g},\n", j.armature);
    text += fmt::format(
        "        friction={:.9g},  # at rest\n"
        "        dynamic_friction={:.9g},\n"
        "        viscous_friction={:.9g},{}\n",
        f.breakaway, f.coulomb, f.viscous,
        j.back_emf > 0 ? fmt::format("  # {:.9g} of it by the motor's back-EMF", j.back_emf) : "");
    if (j.effort_limit < infinity)
        text += fmt::format("        {}={:.9g},\n", delayed ? "effort_limit" : "effort_limit_sim", j.effort_limit);
    if (delayed)
        text += fmt::format("        min_delay={0},  # physics steps of {1:g} s\n        max_delay={0},\n",
                            a.delay_steps, a.timestep);
    text += "    ),\n}\n";
    if (!j.reference_velocity) text += "# the loop damps velocity itself: leave the velocity target at 0\n";
    return text;
}

std::string ros2_control_text(const ExportAnswer& a, const std::string& name)
{
    const auto& j = a.joint;
    const double rate = 1 / a.timestep;
    std::string text = fmt::format(
        "# joint_trajectory_controller with an effort interface: effort = p e + i ∫e + d ė{}\n"
        "controller_manager:\n"
        "  ros__parameters:\n"
        "    update_rate: {}\n"
        "    {}_controller:\n"
        "      type: joint_trajectory_controller/JointTrajectoryController\n"
        "{}_controller:\n"
        "  ros__parameters:\n"
        "    joints: [{}]\n"
        "    command_interfaces: [effort]\n"
        "    state_interfaces: [position, velocity]\n"
        "    gains:\n"
        "      {}:\n"
        "        p: {:#.9g}\n"
        "        i: {:#.9g}\n"
        "        d: {:#.9g}\n",
        j.ratio != 1
            ? fmt::format(", at the joint's side of the gear (shaft gains times N² = {:.9g})", j.ratio * j.ratio)
            : "",
        std::lround(rate), name, name, name, name, j.k_p, j.k_i, j.k_v);
    if (j.k_i != 0 && j.integral_limit < infinity) text += fmt::format("        i_clamp: {:#.9g}\n", j.integral_limit);
    return text;
}

}  // namespace stickslip::files
