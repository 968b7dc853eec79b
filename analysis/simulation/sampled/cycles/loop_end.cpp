#include "analysis/simulation/sampled/cycles/loop_end.h"

namespace stickslip {

Outcome LoopEnd::outcome() const
{
    switch (kind) {
        case Kind::steady:
            return Outcome::stable_sliding;
        case Kind::undecided:
            return reason == Reason::solver_failed ? Outcome::solver_failure : Outcome::undecided;
        case Kind::period_n:
            return Outcome::period_n;
        case Kind::held:
            return Outcome::held;
        case Kind::irregular:
        case Kind::cycle:
            break;
    }
    if (reversed) return Outcome::reversal;
    if (stick_fraction > 0) return Outcome::stick_slip;
    return kind == Kind::irregular ? Outcome::irregular : Outcome::limit_cycle;
}

}  // namespace stickslip
