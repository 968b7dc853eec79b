#include "analysis/simulation/mirrored.h"

namespace stickslip {
namespace {

/// Without a sign on 0.
void turn(std::vector<double>& values)
{
    for (double& value : values) value = 0 - value;
}

}  // namespace

SimulateOptions mirrored(SimulateOptions options)
{
    if (is_set(options.disturbance.size) && options.disturbance.kind != DisturbanceKind::start)
        options.disturbance.size *= -1;
    options.force.impulse *= -1;
    turn(options.force.value);
    return options;
}

void mirror(Trajectory& path, const Friction& friction)
{
    for (auto* values : {&path.position, &path.velocity, &path.friction}) turn(*values);
    // states that deflect have a direction, those that age none
    const auto forwards = steady_state(friction, path.commanded_velocity),
               backwards = steady_state(friction, -path.commanded_velocity);
    for (std::size_t i = 0; i < path.states.size(); ++i)
        if (forwards[i] * backwards[i] < 0) turn(path.states[i]);
    path.commanded_velocity *= -1, path.steady_friction *= -1;
}

}  // namespace stickslip
