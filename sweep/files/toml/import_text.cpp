#include "sweep/files/toml/import_text.h"

#include "analysis/joint/parameters.h"
#include "sweep/files/toml/joint_file.h"
#include "sweep/words/robot_description_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

std::string with(double value, Quantity quantity, Units units)
{
    return fmt::format("{:.6g} {}", value, unit_of(quantity, units));
}

/// A line of its own, whatever a name of the description has in it: TOML allows no control characters in comments.
std::string comment(std::string text)
{
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
    return "# " + text + "\n";
}

std::string limits_text(const RobotJoint& j, Units units)
{
    std::string text;
    if (std::isfinite(j.low) && std::isfinite(j.high))
        text += fmt::format("# travel {:.6g} to {}\n", j.low, with(j.high, Quantity::position, units));
    if (std::isfinite(j.velocity)) text += "# top speed " + with(j.velocity, Quantity::velocity, units) + "\n";
    if (j.gear != 1) text += fmt::format("# gear of the actuator: {:.6g}\n", j.gear);
    return text;
}

/// Lines for what is missing, in the table where it belongs.
std::string with_missing(std::string text, const ImportAnswer& answer)
{
    Joint joint = answer.joint;
    for (const auto& p : parameters(joint)) {
        if (std::find(answer.missing.begin(), answer.missing.end(), p.path) == answer.missing.end()) continue;
        const auto dot = p.path.rfind('.');
        const auto header = fmt::format("[{}]\n", p.path.substr(0, dot));
        const auto line = fmt::format("# {} =    # {}, required: {}; the robot's description does not have it\n",
                                      p.path.substr(dot + 1), unit_of(p.quantity, units_of(joint)), p.help);
        const auto at = text.find(header);
        if (at == std::string::npos)
            text += "\n" + header + line;
        else
            text.insert(at + header.size(), line);
    }
    return text;
}

}  // namespace

std::string import_text(const ImportAnswer& answer, const std::string& robot_file, const std::string& pose_file)
{
    const auto& d = answer.dynamics;
    const Units units = units_of(answer.joint);
    std::string text =
        comment(fmt::format("Joint \"{}\" of {}, all other joints standing still {}.", answer.described.name,
                            robot_file, pose_file.empty() ? "at their zero" : "as in " + pose_file));
    text += fmt::format("# The joint moves {} {} of {:.6g} kg: inertia {} about it, armature {}.\n", d.bodies,
                        d.bodies == 1 ? "body" : "bodies", d.mass, with(d.inertia, Quantity::inertia, units),
                        with(answer.described.armature, Quantity::inertia, units));
    text += fmt::format("# At {} gravity is {}", with(answer.position, Quantity::position, units),
                        with(d.gravity_effort, Quantity::effort, units));
    text += units.motion == Motion::revolute
                ? ", its stiffness " + with(d.gravity_stiffness, Quantity::stiffness, units) + ".\n"
                : ".\n";
    for (const auto& of : answer.impossible) text += comment(impossible_inertia_text(of));
    for (const auto& of : answer.suspected) text += comment(suspected_unit_text(of));
    for (const auto& of : answer.not_taken) text += comment(not_taken_text(of));
    for (const auto& of : answer.beyond) text += comment("The robot cannot reach this pose: " + beyond_limits_text(of));
    text += limits_text(answer.described, units);
    if (answer.described.friction == 0)
        text += "# Friction is 0 in the robot's description: put in what was measured.\n";
    return with_missing(text + "\n" + joint_text(answer.joint), answer);
}

}  // namespace stickslip
