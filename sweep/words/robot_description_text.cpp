#include "sweep/words/robot_description_text.h"

#include <fmt/format.h>

namespace stickslip {

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

std::string beyond_limits_text(const PoseBeyondLimits& of)
{
    const auto& j = of.joint;
    const auto unit = j.kind == RobotJointKind::hinge ? "rad" : "m";
    return fmt::format("joint \"{}\" is at {:.6g} {}, outside its limits {:.6g} to {:.6g} {} ({})", j.name, of.position,
                       unit, j.low, j.high, unit, j.place);
}

}  // namespace stickslip
