// SDFormat: a model for Gazebo with joint dynamics, limits and the position controller that comes with it.
#include "sweep/files/simulators/simulator_text.h"

#include <fmt/format.h>

namespace stickslip::files {
namespace {

std::string link(const std::string& name, const Pendulum& p)
{
    return fmt::format(
        "    <link name=\"{0}\">\n"
        "      <inertial>\n"
        "        <pose>{1:.9g} 0 {2:.9g} 0 0 0</pose>\n"
        "        <mass>{3:.9g}</mass>\n"
        "        "
        "<inertia><ixx>{4:.9g}</ixx><iyy>{4:.9g}</iyy><izz>{4:.9g}</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></"
        "inertia>\n"
        "      </inertial>\n"
        "    </link>\n",
        name, p.x, p.z, p.mass, p.own_inertia);
}

std::string joint(const SimulatorJoint& j, const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& limits, const SimulatorFriction& f)
{
    const bool turns = j.motion == Motion::revolute;
    return fmt::format(
        "    <joint name=\"{}\" type=\"{}\">\n"
        "      <parent>{}</parent>\n"
        "      <child>{}</child>\n"
        "      <axis>\n"
        "        <xyz>{}</xyz>\n"
        "{}"
        "        <dynamics><damping>{:.9g}</damping><friction>{:.9g}</friction></dynamics>\n"
        "      </axis>\n"
        "    </joint>\n",
        name, turns ? "revolute" : "prismatic", parent, child, turns ? "0 -1 0" : "1 0 0", limits, f.viscous,
        f.coulomb);
}

std::string effort_limit(const SimulatorJoint& j)
{
    if (j.effort_limit == infinity) return "";
    return fmt::format("        <limit><effort>{:.9g}</effort></limit>\n", j.effort_limit);
}

std::string controller(const SimulatorJoint& j, const std::string& name)
{
    const auto limit =
        j.effort_limit < infinity
            ? fmt::format("      <cmd_max>{0:.9g}</cmd_max>\n      <cmd_min>-{0:.9g}</cmd_min>\n", j.effort_limit)
            : "";
    return fmt::format(
        "    <plugin filename=\"gz-sim-joint-position-controller-system\" "
        "name=\"gz::sim::systems::JointPositionController\">\n"
        "      <joint_name>{}</joint_name>\n"
        "      <p_gain>{:.9g}</p_gain>\n"
        "      <i_gain>{:.9g}</i_gain>\n"
        "      <d_gain>{:.9g}</d_gain>\n"
        "{}"
        "    </plugin>\n",
        name, j.k_p, j.k_i, j.k_v, limit);
}

}  // namespace

std::string sdf_text(const ExportAnswer& a, const std::string& name)
{
    const auto& j = a.joint;
    std::string text = fmt::format("<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n  <model name=\"{}\">\n", name);
    if (j.backlash > 0 && j.two_bodies()) {
        text += link(name + "_motor", rotor_of(j)) + link(name + "_link", pendulum(j, j.link_inertia));
        text += joint(j, name, "world", name + "_motor", effort_limit(j), motor_friction(j));
        const auto band = fmt::format("        <limit><lower>{:.9g}</lower><upper>{:.9g}</upper></limit>\n",
                                      -j.backlash / 2, j.backlash / 2);
        text += joint(j, name + "_backlash", name + "_motor", name + "_link", band, j.link);
    } else {
        text += link(name + "_link", pendulum(j, j.inertia()));
        text += joint(j, name, "world", name + "_link", effort_limit(j), j.friction());
    }
    if (!j.feedback_link) text += controller(j, name);
    return text + "  </model>\n</sdf>\n";
}

}  // namespace stickslip::files
