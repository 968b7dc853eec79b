#include "analysis/boundary/trace/coordinates.h"

#include "analysis/joint/parameters.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

namespace stickslip {
namespace {

/// The numbers of a role that the linear theory reads and that are there: friction, stiffness, inertia, speed.
std::vector<Coordinate> of_roles(Joint joint, std::initializer_list<Role> roles)
{
    std::vector<Coordinate> found;
    for (const auto& leaf : parameters(joint)) {
        if (std::find(roles.begin(), roles.end(), leaf.role) == roles.end()) continue;
        if (*leaf.value == 0 || !std::isfinite(*leaf.value)) continue;
        found.push_back({leaf.path, ""});
    }
    // with one state, B matters by what it exceeds A by
    const double* A = find_parameter(joint, "friction.A");
    const double* B = find_parameter(joint, "friction.B");
    for (auto& c : found)
        if (A && B && find_parameter(joint, c.path) == B && *B > *A) c = {"friction.B", "friction.A"};
    return found;
}

double value_in(const Joint& joint, const Coordinate& c)
{
    const double* number = find_parameter(joint, c.path);
    const double* less = c.less.empty() ? nullptr : find_parameter(joint, c.less);
    if (!number || (!c.less.empty() && !less)) return missing;
    const double value = *number - (less ? *less : 0);
    return (less ? value > 0 : value != 0) && std::isfinite(value) ? value : missing;
}

}  // namespace

double value_of(const Joint& joint, const Coordinate& c)
{
    return value_in(joint, c);
}

MovableJoint::MovableJoint(const Joint& joint, const std::vector<Coordinate>& coordinates) : joint_(joint)
{
    const auto leaves = parameters(joint_);
    for (const auto& c : coordinates) {
        const double value = value_in(joint_, c);
        if (std::isnan(value))
            throw std::invalid_argument(c.less.empty()
                                            ? c.path + ": is 0 or no number of this joint"
                                            : c.path + " − " + c.less + ": is not a positive parameter of this joint");
        const double* less = c.less.empty() ? nullptr : find_parameter(joint_, c.less);
        const double* number = find_parameter(joint_, c.path);
        const auto leaf = std::ranges::find(leaves, number, &Parameter::value);
        Range range = leaf == leaves.end() ? Range{} : leaf->range;
        range.whole = false;  // a number that is moved a little is between two
        numbers_.push_back({number_at(joint_, c.path), less, value, c.scale, range});
    }
}

const Joint& MovableJoint::at(const std::vector<double>& q)
{
    for (const bool difference : {false, true})
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            const auto& n = numbers_[i];
            if ((n.less != nullptr) != difference) continue;
            n.value = n.from * std::exp(q[i] * n.scale) + (difference ? *n.less : 0);
        }
    return joint_;
}

bool MovableJoint::allowed() const
{
    return std::ranges::all_of(numbers_, [](const Number& n) { return n.range.holds(n.value); });
}

Joint moved(const Joint& joint, const std::vector<Coordinate>& coordinates, const std::vector<double>& q)
{
    return MovableJoint(joint, coordinates).at(q);
}

std::vector<Coordinate> natural_coordinates(const Joint& joint)
{
    return of_roles(joint, {Role::law, Role::stiffness, Role::inertia, Role::speed});
}

std::vector<Coordinate> friction_coordinates(const Joint& joint)
{
    return of_roles(joint, {Role::law});
}

}  // namespace stickslip
