// Parameters that no linear answer of a joint depends on: along them the linear theory has no boundary to deny.
#pragma once
#include "analysis/boundary/kinds/nearest.h"
#include "analysis/loop/loop_use.h"
#include "analysis/results/stability_map.h"

#include <optional>
#include <string>
#include <vector>

namespace stickslip {

struct IdleAxis {
    std::string path;
    std::optional<WhyNot> why;  ///< why the theory has no term for it; none where it has one that changes nothing here
    bool matters = false;       ///< somewhere along the axis a verdict without it may be wrong
    bool at_rest = false;       ///< no answer at a set point depends on it, or, with `matters`, has a place for it
};

/// Whether the joint has the parameter and the theory leaves it out: what it does is not judged.
inline bool is_left_out(const IdleAxis& axis)
{
    if (axis.at_rest) return axis.matters;
    return axis.why && *axis.why != WhyNot::overruled && *axis.why != WhyNot::other_kind &&
           *axis.why != WhyNot::no_feedback;
}

/// Whether what is answered along the axis may be wrong; `simulated`: outcomes beside the linear theory follow it.
inline bool may_be_wrong_along(const IdleAxis& axis, bool simulated)
{
    return axis.matters && !simulated;
}

/// Axes along which no linear answer changes at this joint, tried at their ends and between them wherever there is an
/// answer. In the order of the axes.
std::vector<IdleAxis> idle_axes(const Joint& joint, const std::vector<Axis>& axes);

/// The axis if no answer at a set point changes along it.
std::optional<IdleAxis> idle_at_rest(const Joint& joint, const Axis& axis);

/// The same of uncertain parameters, each within its share. Differences of two parameters are never idle.
std::vector<IdleAxis> idle_coordinates(const Joint& joint, const Uncertainty& uncertainty);

/// Of a path among them, of the linear theory or at rest, or nullptr.
inline const IdleAxis* idle_axis(const std::vector<IdleAxis>& idle, const std::string& path, bool at_rest = false)
{
    for (const auto& axis : idle)
        if (axis.path == path && axis.at_rest == at_rest) return &axis;
    return nullptr;
}

}  // namespace stickslip
