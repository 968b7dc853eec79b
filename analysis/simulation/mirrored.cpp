#include "analysis/simulation/mirrored.h"

namespace stickslip {
namespace {

/// Without a sign on 0.
void turn(std::vector<double>& values)
{
    for (double& value : values) value = 0 - value;
}

/// Whether state i has a direction, as one that deflects: one that ages has none.
bool has_direction(const Friction& friction, double V0, std::size_t i)
{
    const auto there = steady_state(friction, V0), back = steady_state(friction, -V0);
    return i < there.size() && there[i] * back[i] < 0;
}

}  // namespace

Disturbance mirrored(Disturbance disturbance, const Friction& friction, double V0)
{
    const auto kind = disturbance.kind;
    const bool ages = kind == DisturbanceKind::state && !has_direction(friction, V0, 0);
    if (is_set(disturbance.size) && kind != DisturbanceKind::start && !ages) disturbance.size *= -1;
    return disturbance;
}

SimulateOptions mirrored(SimulateOptions options, const Friction& friction, double V0)
{
    options.disturbance = mirrored(options.disturbance, friction, V0);
    options.force.impulse *= -1;
    turn(options.force.value);
    return options;
}

void mirror(Trajectory& path, const Friction& friction)
{
    for (auto* values : {&path.position, &path.velocity, &path.friction}) turn(*values);
    for (std::size_t i = 0; i < path.states.size(); ++i)
        if (has_direction(friction, path.commanded_velocity, i)) turn(path.states[i]);
    path.commanded_velocity *= -1, path.steady_friction *= -1;
}

}  // namespace stickslip
