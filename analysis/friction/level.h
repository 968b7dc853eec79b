// The level of a friction law, which place, time and load add to.
#pragma once
#include "analysis/friction/friction.h"

#include <algorithm>
#include <variant>

namespace stickslip {

/// Takes each number [N | N·m] of a law that place, time and load add to; false for a law that has none.
template <class Take>
bool with_levels(FrictionLaw& law, Take&& take)
{
    return std::visit(
        [&](auto& l) {
            if constexpr (requires { l.c0; })
                return take(l.c0), true;
            else if constexpr (requires { l.kinetic; })
                return take(l.kinetic), take(l.breakaway), true;
            else if constexpr (requires { l.breakaway; })
                return take(l.coulomb), take(l.breakaway), true;
            else if constexpr (requires { l.coulomb; })
                return take(l.coulomb), true;
            else if constexpr (requires { l.f0; })
                return take(l.f0), true;
            else
                return false;
        },
        law);
}

/// No law has a level below zero.
inline void raise(FrictionLaw& law, double by)
{
    with_levels(law, [by](double& level) { level = std::max(0.0, level + by); });
}

}  // namespace stickslip
