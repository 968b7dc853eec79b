#include "sweep/words/robot_description_text.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

/// What the element does, and what becomes of it.
const char* consequence(NotTakenReason reason)
{
    switch (reason) {
        case NotTakenReason::spring:
            return "pulls the joint to a position: left out, the joint file has no spring to the ground";
        case NotTakenReason::target:
            return "filters or delays its target, not the feedback: left out";
        case NotTakenReason::coupling:
            return "couples joints and loads this one: left out";
        case NotTakenReason::actuator:
            return "acts on the joint: left out, the joint file cannot express it";
        case NotTakenReason::limit:
            return "limits its own part of the effort, to which another servo adds: the limit is left out";
        case NotTakenReason::lopsided:
            return "limits one direction more than the other: the joint file has the wider limit in both";
        case NotTakenReason::nonlinear:
            return "damps also with the square or cube of velocity: the joint file has the linear part alone";
        case NotTakenReason::medium:
            return "puts the robot into a medium: its drag and lift are left out";
        case NotTakenReason::safety:
            return "limits velocity and effort near the ends of travel: left out";
    }
    return "";
}

}  // namespace

std::string impossible_inertia_text(const ImpossibleInertia& of)
{
    const auto& I = of.moments;
    return fmt::format(
        "{}: {} has the principal inertias {:.4g}, {:.4g} and {:.4g} kg·m², which no rigid body has: the greatest is "
        "above the sum of the others. It counts as it is written.",
        of.place, of.body, I[0], I[1], I[2]);
}

std::string suspected_unit_text(const SuspectedUnit& of)
{
    if (of.kind == SuspectedUnit::Kind::length)
        return fmt::format(
            "{}: {} reaches {:.4g} m, which no link of an arm does: lengths are in metres, and inertias in kg·m². It "
            "counts as it is written.",
            of.place, of.of, of.value);
    return fmt::format("{}: {} may turn by {:.4g} rad between its limits: angles are in radians.", of.place, of.of,
                       of.value);
}

std::string not_taken_text(const NotTaken& of)
{
    const std::string name = of.name.empty() ? "" : " \"" + of.name + "\"";
    const std::string with = of.attributes.empty() ? "" : " (" + of.attributes + ")";
    return fmt::format("{}: <{}{}>{} {}.", of.place, of.element, name, with, consequence(of.reason));
}

std::string beyond_limits_text(const PoseBeyondLimits& of)
{
    const auto& j = of.joint;
    const auto unit = j.kind == RobotJointKind::hinge ? "rad" : "m";
    return fmt::format("joint \"{}\" is at {:.6g} {}, outside its limits {:.6g} to {:.6g} {} ({})", j.name, of.position,
                       unit, j.low, j.high, unit, j.place);
}

std::vector<std::string> unreachable_poses_text(const Joint& joint, const std::vector<Axis>& axes)
{
    constexpr double written = 1e-4;  // rad or m: limits are written with few digits
    std::vector<std::string> texts;
    if (!joint.pose.of) return texts;
    for (const auto& axis : axes)
        for (const auto& other : joint.pose.of->neighbours) {
            if (axis.path != "pose." + other.name) continue;
            const double low = axis.values.front(), high = axis.values.back();
            if (low >= other.lower - written && high <= other.upper + written) continue;
            texts.push_back(fmt::format(
                "the axis {} runs from {:.6g} to {:.6g} {}, the limits of joint \"{}\" are {:.6g} "
                "to {:.6g}: the robot cannot reach all of these poses",
                axis.path, low, high, unit_of(other.quantity, units_of(joint)), other.name, other.lower, other.upper));
        }
    return texts;
}

}  // namespace stickslip
