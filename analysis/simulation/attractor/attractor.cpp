#include "analysis/simulation/attractor/attractor.h"

namespace stickslip {

void Attractor::take(const Turn& turn)
{
    period = turn.period();
    velocity_min = turn.velocity_min;
    velocity_max = turn.velocity_max;
    position_min = turn.position_min;
    position_max = turn.position_max;
    rest_time = turn.rest_time;
    reversed = turn.reversed;
    start = turn.state;
}

void Attractor::take(const Cycle& cycle)
{
    path = DecisionPath::shooting;
    period = cycle.period;
    velocity_min = cycle.velocity_min;
    velocity_max = cycle.velocity_max;
    position_min = cycle.position_min;
    position_max = cycle.position_max;
    rest_time = cycle.rest_time;
    reversed = cycle.velocity_min < 0;
    start = cycle.start;
    multipliers = cycle.multipliers;
}

bool Attractor::oscillates() const
{
    return kind == Kind::cycle || kind == Kind::period_n || kind == Kind::irregular || kind == Kind::held;
}

Outcome Attractor::outcome() const
{
    switch (kind) {
        case Kind::steady:
            return Outcome::stable_sliding;
        case Kind::period_n:
            return Outcome::period_n;
        case Kind::irregular:
            return Outcome::irregular;
        case Kind::undecided:
            return Outcome::undecided;
        case Kind::failure:
            return diverged ? Outcome::undecided : Outcome::solver_failure;
        case Kind::held:
            return Outcome::stick_slip;
        case Kind::cycle:
            break;
    }
    if (reversed) return Outcome::reversal;
    return rest_time > 0 ? Outcome::stick_slip : Outcome::limit_cycle;
}

}  // namespace stickslip
