#include "sweep/files/simulators/simulator_text.h"

#include "sweep/files/text/bad_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace stickslip {
namespace {

/// XML, YAML and Python each quote a name in their own way, and robot descriptions refer to it from elsewhere: what
/// needs quotes in any of them is no name of a joint.
void require_name(const std::string& name)
{
    constexpr std::string_view breaks = "\"'`<>&\\{}[]#:,|%@!?*=;$";
    const bool plain = std::ranges::none_of(name, [&](char c) {
        return (static_cast<unsigned char>(c) <= ' ') || c == '\x7f' || breaks.find(c) != std::string_view::npos;
    });
    if (name.empty() || !plain)
        throw BadInput("the name of the joint: got \"" + name +
                       "\"; expected letters, digits and _ - . /, which XML, YAML and Python need not quote");
}

}  // namespace

std::string simulator_text(const ExportAnswer& answer, const std::string& name)
{
    require_name(name);
    switch (answer.to) {
        case Simulator::mjcf:
            return files::mjcf_text(answer, name);
        case Simulator::urdf:
            return files::urdf_text(answer, name);
        case Simulator::sdf:
            return files::sdf_text(answer, name);
        case Simulator::isaaclab:
            return files::isaaclab_text(answer, name);
        case Simulator::ros2_control:
            return files::ros2_control_text(answer, name);
    }
    return "";
}

files::Pendulum files::pendulum(const SimulatorJoint& joint, double inertia)
{
    Pendulum p;
    if (joint.motion == Motion::prismatic) {
        p.mass = inertia;
        p.own_inertia = inertia * 1e-3;  // a sliding body never turns
        return p;
    }
    p.own_inertia = inertia;
    if (joint.gravity_amplitude == 0) return p;
    constexpr double g = 9.81;
    const double amplitude = std::abs(joint.gravity_amplitude);
    const double arm = 0.5 * inertia * g / amplitude;  // then mass · arm² is half of the inertia
    const double phase = joint.gravity_phase + (joint.gravity_amplitude < 0 ? std::numbers::pi : 0);
    p.mass = amplitude / (g * arm);
    p.x = arm * std::sin(phase);
    p.z = -arm * std::cos(phase);
    p.own_inertia = inertia - p.mass * arm * arm;
    return p;
}

files::Pendulum files::rotor_of(const SimulatorJoint& joint)
{
    constexpr double little =
        1e-3;  // of a turning rotor the mass, of a sliding one the inertia, neither of which moves
    Pendulum rotor;
    rotor.mass = joint.motion == Motion::prismatic ? joint.armature : little;
    rotor.own_inertia = joint.motion == Motion::prismatic ? little * joint.armature : joint.armature;
    return rotor;
}

SimulatorFriction files::motor_friction(const SimulatorJoint& joint)
{
    SimulatorFriction friction = joint.motor;
    friction.viscous += joint.back_emf;
    return friction;
}

}  // namespace stickslip
