#include "analysis/simulation/mirrored.h"

#include "analysis/simulation/flows/backwards.h"

namespace stickslip {
namespace {

/// Without a sign on 0.
void turn(std::vector<double>& values)
{
    for (double& value : values) value = 0 - value;
}

}  // namespace

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
