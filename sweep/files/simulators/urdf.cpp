// URDF: links, joint with dynamics and limits. The motor's inertia turns with the link; with backlash it is a link of
// its own behind a hinge that moves freely within the dead band.
#include "sweep/files/simulators/simulator_text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip::files {
namespace {

std::string link(const std::string& name, const Pendulum& p)
{
    return fmt::format(
        "  <link name=\"{0}\">\n"
        "    <inertial>\n"
        "      <origin xyz=\"{1:.9g} 0 {2:.9g}\" rpy=\"0 0 0\"/>\n"
        "      <mass value=\"{3:.9g}\"/>\n"
        "      <inertia ixx=\"{4:.9g}\" ixy=\"0\" ixz=\"0\" iyy=\"{4:.9g}\" iyz=\"0\" izz=\"{4:.9g}\"/>\n"
        "    </inertial>\n"
        "  </link>\n",
        name, p.x, p.z, p.mass, p.own_inertia);
}

std::string hinge(const SimulatorJoint& j, const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& limits, const SimulatorFriction& f, bool limited)
{
    const bool turns = j.motion == Motion::revolute;
    return fmt::format(
        "  <joint name=\"{}\" type=\"{}\">\n"
        "    <parent link=\"{}\"/>\n"
        "    <child link=\"{}\"/>\n"
        "    <axis xyz=\"{}\"/>\n"
        "{}"
        "    <dynamics damping=\"{:.9g}\" friction=\"{:.9g}\"/>\n"
        "  </joint>\n",
        name,
        !turns    ? "prismatic"
        : limited ? "revolute"
                  : "continuous",
        parent, child, turns ? "0 -1 0" : "1 0 0", limits, f.viscous, f.coulomb);
}

/// URDF wants a velocity with every limit and a travel with every slide; joint.toml has neither.
std::string travel(const SimulatorJoint& j)
{
    const std::string effort = j.effort_limit < infinity ? fmt::format("{:.9g}", j.effort_limit) : "1e9";
    const std::string speed = j.no_load_speed < infinity ? fmt::format("{:.9g}", j.no_load_speed) : "1e9";
    const bool slides = j.motion == Motion::prismatic;
    return fmt::format(
        "    <!-- 1e9: no limit is known; put in your robot's -->\n    <limit {}effort=\"{}\" velocity=\"{}\"/>\n",
        slides ? "lower=\"-1e9\" upper=\"1e9\" " : "", effort, speed);
}

}  // namespace

std::string urdf_text(const ExportAnswer& a, const std::string& name)
{
    const auto& j = a.joint;
    std::string text = fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"base\"/>\n", name);
    if (j.backlash > 0 && j.two_bodies()) {
        text += link(name + "_motor", rotor_of(j)) + link(name + "_link", pendulum(j, j.link_inertia));
        text += hinge(j, name, "base", name + "_motor", travel(j), motor_friction(j), false);
        text += fmt::format("  <!-- backlash: free within ±{:.9g}, no actuator -->\n", j.backlash / 2);
        const auto band = fmt::format("    <limit lower=\"{:.9g}\" upper=\"{:.9g}\" effort=\"0\" velocity=\"1e9\"/>\n",
                                      -j.backlash / 2, j.backlash / 2);
        text += hinge(j, name + "_backlash", name + "_motor", name + "_link", band, j.link, true);
    } else {
        text += link(name + "_link", pendulum(j, j.inertia()));
        text += hinge(j, name, "base", name + "_link", travel(j), j.friction(), false);
    }
    return text + "</robot>\n";
}

}  // namespace stickslip::files
