#include "analysis/simulation/flows/backwards.h"

namespace stickslip {

bool has_direction(const Friction& friction, double V0, std::size_t i)
{
    const auto there = steady_state(friction, V0), back = steady_state(friction, -V0);
    return i < there.size() && there[i] * back[i] < 0;
}

Disturbance mirrored(Disturbance disturbance, const Friction& friction, double V0)
{
    const auto kind = disturbance.kind;
    const bool ages = kind == DisturbanceKind::state && !has_direction(friction, V0, 0);
    if (is_set(disturbance.size) && kind != DisturbanceKind::start && !ages) disturbance.size *= -1;
    return disturbance;
}

}  // namespace stickslip
