#include "analysis/boundary/trace/coordinates.h"

#include "analysis/joint/parameters.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace stickslip {
namespace {

/// Numbers that only name a unit or a level: the linear theory does not read them.
bool idle(const std::string& path)
{
    for (const char* name : {".f0", ".V_star", ".temperature", ".exponent", "average"})
        if (path.ends_with(name)) return true;
    return false;
}

/// A number of a law itself, "friction.L" or "friction.motor.B.0", not of a term beside the law such as a ripple. The
/// normal load is a factor of all of them, which move by themselves.
bool is_law(std::string_view path)
{
    if (!path.starts_with("friction.") || path.ends_with(".normal_load")) return false;
    path.remove_prefix(std::string_view("friction.").size());
    for (const std::string_view body : {"motor.", "transmission.", "link."})
        if (path.starts_with(body)) path.remove_prefix(body.size());
    const auto dot = path.find('.');
    return dot == path.npos || (dot + 1 < path.size() && path[dot + 1] >= '0' && path[dot + 1] <= '9');
}

bool is_friction(const Coordinate& c)
{
    return c.path.starts_with("friction");
}

}  // namespace

double value_of(const Joint& given, const Coordinate& c)
{
    Joint joint = given;
    const double* number = find_parameter(joint, c.path);
    const double* less = c.less.empty() ? nullptr : find_parameter(joint, c.less);
    if (!number || (!c.less.empty() && !less)) return missing;
    const double value = *number - (less ? *less : 0);
    return value > 0 && std::isfinite(value) ? value : missing;
}

MovableJoint::MovableJoint(const Joint& joint, const std::vector<Coordinate>& coordinates) : joint_(joint)
{
    for (const auto& c : coordinates) {
        const double value = value_of(joint, c);
        if (std::isnan(value))
            throw std::invalid_argument(c.path + (c.less.empty() ? "" : " − " + c.less) +
                                        ": is no positive number of this joint");
        double* less = c.less.empty() ? nullptr : find_parameter(joint_, c.less);
        numbers_.push_back({find_parameter(joint_, c.path), less, value, c.scale});
    }
}

const Joint& MovableJoint::at(const std::vector<double>& q)
{
    for (const bool difference : {false, true})
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            const auto& n = numbers_[i];
            if ((n.less != nullptr) != difference) continue;
            *n.value = n.from * std::exp(q[i] * n.scale) + (difference ? *n.less : 0);
        }
    return joint_;
}

Joint moved(const Joint& joint, const std::vector<Coordinate>& coordinates, const std::vector<double>& q)
{
    return MovableJoint(joint, coordinates).at(q);
}

std::vector<Coordinate> natural_coordinates(const Joint& given)
{
    Joint joint = given;
    std::vector<Coordinate> found;
    for (const auto& leaf : parameters(joint)) {
        const auto& path = leaf.path;
        const bool stiffness = path.starts_with("joint.") && path.ends_with("stiffness");
        const bool inertia = path.starts_with("joint.") && path.ends_with("inertia");
        const bool velocity = path == "control.V0" || path == "control.force_rate";
        if (!(is_law(path) || stiffness || inertia || velocity) || idle(path)) continue;
        if (!(*leaf.value > 0) || !std::isfinite(*leaf.value)) continue;
        found.push_back({path, ""});
    }
    // with one state, B matters by what it exceeds A by
    const double* A = find_parameter(joint, "friction.A");
    const double* B = find_parameter(joint, "friction.B");
    for (auto& c : found)
        if (A && B && find_parameter(joint, c.path) == B && *B > *A) c = {"friction.B", "friction.A"};
    return found;
}

std::vector<Coordinate> friction_coordinates(const Joint& joint)
{
    auto found = natural_coordinates(joint);
    std::erase_if(found, [](const Coordinate& c) { return !is_friction(c); });
    return found;
}

}  // namespace stickslip
