// MJCF: loads in MuJoCo as it stands.
#include "sweep/files/simulators/simulator_text.h"

#include <fmt/format.h>

#include <cmath>

namespace stickslip::files {
namespace {

/// Impedance close to 1 and a reference damping of 1/step: MuJoCo's regularised dry friction then creeps by 1e-7 of the
/// speed that its force would give the body in a second.
std::string friction(const SimulatorFriction& f, double step)
{
    std::string text;
    if (f.coulomb > 0)
        text += fmt::format(" frictionloss=\"{:.9g}\" solreffriction=\"{:g} 1\" solimpfriction=\"0.9999 0.9999 0.001\"",
                            f.coulomb, 2 * step);
    if (f.viscous > 0) text += fmt::format(" damping=\"{:.9g}\"", f.viscous);
    return text;
}

std::string body(const ExportAnswer& a, const std::string& name, double inertia, double armature,
                 const SimulatorFriction& f, bool link)
{
    const auto& j = a.joint;
    Pendulum p = link ? pendulum(j, inertia) : Pendulum{1e-6, 0, 0, 1e-12};
    std::string extra = armature > 0 ? fmt::format(" armature=\"{:.9g}\"", armature) : "";
    if (j.effort_limit < infinity && (!link || !j.two_bodies() || !std::isfinite(j.stiffness)))
        extra += fmt::format(" actuatorfrclimited=\"true\" actuatorfrcrange=\"{:.9g} {:.9g}\"", -j.effort_limit,
                             j.effort_limit);
    const bool turns = j.motion == Motion::revolute;
    return fmt::format(
        "    <body name=\"{0}_body\">\n"
        "      <inertial pos=\"{1:.9g} 0 {2:.9g}\" mass=\"{3:.9g}\" diaginertia=\"{4:.9g} {4:.9g} {4:.9g}\"/>\n"
        "      <joint name=\"{0}\" type=\"{5}\" axis=\"{6}\"{7}{8}/>\n"
        "    </body>\n",
        name, p.x, p.z, p.mass, p.own_inertia, turns ? "hinge" : "slide", turns ? "0 -1 0" : "1 0 0", extra,
        friction(f, a.timestep));
}

std::string tendon(const SimulatorJoint& j, const std::string& name)
{
    return fmt::format(
        "  <!-- Elastic transmission{1}: at the joint's side, between the two hinges. -->\n"
        "  <tendon>\n"
        "    <fixed name=\"{0}_transmission\" stiffness=\"{2:.9g}\" damping=\"{3:.9g}\" springlength=\"{4:.9g} "
        "{5:.9g}\">\n"
        "      <joint joint=\"{0}_motor\" coef=\"1\"/>\n"
        "      <joint joint=\"{0}\" coef=\"-1\"/>\n"
        "    </fixed>\n"
        "  </tendon>\n",
        name, j.backlash > 0 ? " with backlash, the range in which springlength lets it move freely" : "", j.stiffness,
        j.damping, -j.backlash / 2, j.backlash / 2);
}

std::string actuators(const ExportAnswer& a, const std::string& name, const std::string& driven)
{
    const auto& j = a.joint;
    std::string servo;
    if (!j.feedback_link) {
        servo = fmt::format("    <position name=\"{}_position\" joint=\"{}\" kp=\"{:.9g}\"/>\n", name, driven, j.k_p);
        if (j.k_v != 0)
            servo +=
                fmt::format("    <velocity name=\"{}_velocity\" joint=\"{}\" kv=\"{:.9g}\"/>\n", name, driven, j.k_v);
    }
    const std::string use = j.reference_velocity
                                ? "k_p (target − q) + k_v (target velocity − v): set both controls"
                                : "k_p (target − q) − k_v v: leave the control of the velocity servo at 0";
    const std::string delay =
        a.delay_steps > 0 ? fmt::format(" delay=\"{:g}\" nsample=\"{}\"", j.delay, a.delay_steps + 1) : "";
    const std::string motor =
        fmt::format("<motor name=\"{}_effort\" joint=\"{}\" gear=\"{:.9g}\"{}/>", name, driven, j.ratio, delay);
    if (j.feedback_link) return "  <actuator>\n    " + motor + "\n  </actuator>\n";
    return fmt::format(
        "  <!-- {}.{} -->\n  <actuator>\n{}  </actuator>\n"
        "  <!-- With a loop of your own, effort at the motor's shaft{}: {} -->\n",
        use,
        j.ratio != 1 ? fmt::format(" Gains are those at the motor's shaft times N² = {:.9g}", j.ratio * j.ratio) : "",
        servo, a.delay_steps > 0 ? ", delayed (MuJoCo 3.5 and later)" : "", motor);
}

}  // namespace

std::string mjcf_text(const ExportAnswer& a, const std::string& name)
{
    const auto& j = a.joint;
    const bool elastic = j.two_bodies() && std::isfinite(j.stiffness);
    const SimulatorFriction motor = motor_friction(j);
    std::string text = fmt::format(
        "<!-- Paste body or joint attributes, tendon and actuators into your robot; the file also loads as it stands. "
        "-->\n"
        "<mujoco model=\"{}\">\n"
        "  <compiler angle=\"radian\"/>\n"
        "  <!-- Euler: the implicit integrators misread the damping of a tendon. -->\n"
        "  <option timestep=\"{:g}\" gravity=\"0 0 -9.81\" integrator=\"{}\" iterations=\"50\" tolerance=\"1e-12\"/>\n"
        "  <worldbody>\n",
        name, a.timestep, "Euler");
    if (elastic) {
        text += body(a, name + "_motor", 0, j.armature, motor, false);
        text += body(a, name, j.link_inertia, 0, j.link, true);
        text += "  </worldbody>\n" + tendon(j, name);
    } else {
        text += body(a, name, j.link_inertia, j.armature, j.friction(), true) + "  </worldbody>\n";
    }
    return text + actuators(a, name, elastic ? name + "_motor" : name) + "</mujoco>\n";
}

}  // namespace stickslip::files
