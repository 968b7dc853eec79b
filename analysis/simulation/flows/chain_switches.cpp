// The switches of a chain: which of its bodies stick, and which slide forwards or backwards.
#include "analysis/simulation/flows/chain_flow.h"

#include <algorithm>
#include <cmath>

namespace stickslip {

void ChainFlow::switch_values(const FlowVector& y, const DelayedForces& delayed, double* values) const
{
    for (int i = 0; i < bodies; ++i) {
        const auto& b = body[i];
        if (!b.rests)
            values[i] = 1;
        else if (b.mode == Mode::stuck) {
            const double force_needed = needed(y, i);
            values[i] = 1 - std::abs(force_needed) / limit(y, i, force_needed, delayed);
        } else
            values[i] = velocity(y, i) / b.speed;
    }
}

void ChainFlow::settle(int i, FlowVector& y, const DelayedForces& delayed)
{
    set_velocity(y, i, 0);
    const double force_needed = needed(y, i);
    body[i].mode = std::abs(force_needed) <= limit(y, i, force_needed, delayed) ? Mode::stuck
                   : force_needed > 0                                           ? Mode::forward
                                                                                : Mode::reverse;
}

void ChainFlow::enter(FlowVector& y, const DelayedForces& delayed)
{
    for (int i = 0; i < bodies; ++i) {
        const double v = velocity(y, i);
        body[i].mode = v >= 0 ? Mode::forward : Mode::reverse;
        if (body[i].rests && v == 0) settle(i, y, delayed);
    }
}

void ChainFlow::pass(int i, FlowVector& y, const DelayedForces& delayed)
{
    if (body[i].mode == Mode::stuck)
        body[i].mode = needed(y, i) > 0 ? Mode::forward : Mode::reverse;
    else
        settle(i, y, delayed);
}

bool ChainFlow::anything_rests() const
{
    return std::any_of(body.begin(), body.begin() + bodies, [](const BodyFlow& b) { return b.mode == Mode::stuck; });
}

bool ChainFlow::can_rest() const
{
    return std::any_of(body.begin(), body.begin() + bodies, [](const BodyFlow& b) { return b.rests; });
}

}  // namespace stickslip
